#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "console/debrief/checklist.h"
#include "console/debrief/team_watch.h"
#include "console/debrief/time_scale.h"
#include "idl/overlay/plan.h"

namespace tacit {

/// Whether the first robot is covered while it surveys rooms.
///
/// It surveys each room that it enters otherwise than in flight, that is between "Enemy found." and
/// "Hallway clear."; again and again in the same room is one survey. A room for which it asked, and
/// on whose doorstep the warning came, is a refuge until it tests an object there: then it surveys
/// it after all, hidden. Before the first time it is to
/// say "Cover me." since it was last in a room. As long as it is there and nobody is in flight,
/// another robot of the team is to be in a hallway or in another room; what is short of that may
/// add up to 5 s, the time to take its post. [ours]
class Cover {
 public:
  Cover(const MapPlan& plan, const TimeScale& scale);
  void add(const Event& event, const TeamWatch& team);
  void append_to(Checklist& list) const;

 private:
  struct Survey {
    Deed entry;  ///< The first.
    bool asked = false;
    Tick uncovered = 0;  ///< Ticks without cover.
  };

  /// A survey begins.
  void survey(std::uint32_t room, const Survey& survey);
  void move(const SiteEntered& entered, const Event& event, const TeamWatch& team);
  [[nodiscard]] bool is_uncovered(const TeamWatch& team) const;
  [[nodiscard]] std::string called(std::uint32_t room) const;
  [[nodiscard]] std::string entry_told(std::uint32_t room) const;
  [[nodiscard]] SubTask asking() const;
  [[nodiscard]] SubTask covering() const;

  TimeScale scale_;
  Tick most_uncovered_;
  std::vector<std::string> names_;           ///< Of the rooms.
  std::map<std::uint32_t, Survey> surveys_;  ///< By room.
  std::uint32_t here_ = 0;                   ///< The room that is being surveyed; 0 for none.
  std::optional<Deed> refuge_;               ///< Entered in flight after asking; it is there still.
  std::uint32_t refuge_room_ = 0;
  bool asked_ = false;  ///< Since the first robot was last in a room.
  std::optional<Tick> uncovered_since_;
};

}  // namespace tacit
