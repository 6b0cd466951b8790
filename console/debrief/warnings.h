#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "console/debrief/checklist.h"
#include "console/debrief/team_watch.h"
#include "console/debrief/time_scale.h"

namespace tacit {

/// What the team does about an enemy that sees it; nothing is wanted when none does.
///
/// - Each time a robot is exposed, "Enemy found." is to be said within 10 s before or after, unless
///   the team has been warned and has not heard "Hallway clear." since. Exposures that follow each
///   other within 30 s count as one, and a warning in time for one of them is enough.
/// - After each "Enemy found." every robot is to be in a room within 40 s.
/// - After the last "Hallway clear." the first robot is to go on: to enter a place, test an object,
///   mark a doorway or say something, or the mission is accomplished.
///
/// The times are ours: a robot crosses a room's width in about 20 s.
class Warnings {
 public:
  Warnings(std::size_t team, const TimeScale& scale);
  void add(const Event& event, const TeamWatch& team);
  void append_to(Checklist& list) const;

 private:
  /// Exposures that count as one.
  struct Exposure {
    Deed first;
    Tick last = 0;
    bool warned = false;
  };

  void expose(const RobotExposed& exposed, const Event& event, const TeamWatch& team);
  void hear(const Signalled& said, const Event& event, const TeamWatch& team);
  void warn(const TeamWatch& team);
  void enter(const SiteEntered& entered);
  void go_on(const Event& event);
  /// Whether the time to hide after a warning is over.
  [[nodiscard]] bool is_late(Tick since, Tick now) const { return now - since > hide_; }
  [[nodiscard]] std::optional<Deed> first_late() const;
  [[nodiscard]] SubTask warning() const;
  [[nodiscard]] SubTask hiding() const;
  [[nodiscard]] SubTask going_on() const;

  TimeScale scale_;
  Tick near_;  ///< Between exposure and warning.
  Tick same_;  ///< Between exposures that are one.
  Tick hide_;  ///< From a warning to being in a room.

  std::vector<Exposure> exposures_;
  std::optional<Deed> warned_;                ///< The last time.
  std::vector<std::optional<Tick>> fleeing_;  ///< By robot: since this warning, not yet in a room.
  std::optional<Deed> late_;     ///< Who was not in a room in time, after which warning.
  std::optional<Deed> clear_;    ///< The last "Hallway clear.".
  std::optional<Tick> went_on_;  ///< After that.
  Tick now_ = 0;
  bool over_ = false;
};

}  // namespace tacit
