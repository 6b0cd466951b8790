#pragma once

#include <optional>
#include <vector>

#include "robot_agent/brain/perception/place_memory.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Turns the percepts of a robot in an operation into surroundings. Allocates nothing once it has
/// seen the largest percept.
class OperationPerception {
 public:
  /// How long a signal rings in the ears [ours: a second, so that a robot that changes its state in
  /// the tick of the signal does not miss it].
  static constexpr Tick kRingTicks = 10;
  /// Ticks that the track goes back.
  static constexpr std::size_t kTrackTicks = 100;

  struct Heard {
    Word word;
    Tick tick = 0;  ///< When last.
  };
  /// What outlives a tick, the track apart.
  struct Memory {
    std::optional<OdometryVec> home_m;
    std::optional<OdometryVec> course;
    std::optional<Entrance> entrance;
  };

  /// `start` is where the robot was told that it starts.
  explicit OperationPerception(const WorldPose& start);

  /// Call once per tick, ticks ascending. The result borrows from `percept` and from this.
  [[nodiscard]] const Surroundings& look(const Percept& percept);

  [[nodiscard]] Memory memory() const;
  void resume(const Memory& memory);

 private:
  void sort(const Percept& percept);
  [[nodiscard]] bool is_here(const BodyVec& offset_m) const;
  void find_pose();
  void follow_hallway(const Percept& percept);
  void follow_rooms(Site site);
  void listen(const Percept& percept);
  void remember_way();

  WorldPose start_;
  PlaceMemory home_;
  std::vector<Heard> heard_;
  std::vector<OdometryVec> track_;
  Site last_site_ = Site::Open;
  Surroundings around_;
};

}  // namespace tacit
