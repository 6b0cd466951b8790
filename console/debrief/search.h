#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "console/debrief/checklist.h"
#include "console/debrief/team_watch.h"
#include "console/debrief/time_scale.h"
#include "idl/overlay/ground.h"
#include "idl/overlay/plan.h"

namespace tacit {

/// The search of a building for suspect objects, which are brown; one that can be moved is real.
///
/// Wanted are the hallway if there is one, each room with a way in, a test of each suspect in the
/// rooms that were entered, and an alert when the real one has been found, never before. When the
/// operator has been alerted on it, what has not been looked at yet is not needed any more: rooms,
/// the suspects there, and other suspects in the room of the real one. A room that was entered in
/// flight alone, between "Enemy found." and "Hallway clear.", has not been looked at.
///
/// The rooms of a map without a hallway and without suspects are not wanted: such a building is but
/// a landmark. [ours]
class Search {
 public:
  Search(const MapPlan& plan, Doors doors);
  void add(const Event& event, const TeamWatch& team);
  void append_to(Checklist& list, const TimeScale& scale) const;

 private:
  struct Room {
    std::string name;
    bool open = false;
    bool looked_at = false;  ///< Entered otherwise than in flight, or an object was tested there.
    std::optional<Deed> entered;
  };
  struct Suspect {
    std::uint32_t room = 0;  ///< Number of the room it lies in; 0 for none.
    bool real = false;
    std::uint32_t tests = 0;
    Deed tested;  ///< The last time.
    Finding finding = Finding::None;
  };

  void enter(const SiteEntered& entered, const Event& event, const TeamWatch& team);
  void test(const ObjectTested& tested, const Event& event);
  void alert(const Alerted& alerted, const Event& event);

  [[nodiscard]] bool has_real() const;
  [[nodiscard]] bool is_wanted(const Room& room) const;
  [[nodiscard]] bool is_wanted(const Suspect& suspect) const;
  [[nodiscard]] SubTask task(const Room& room, const TimeScale& scale) const;
  [[nodiscard]] SubTask task(std::uint32_t object, const Suspect& suspect,
                             const TimeScale& scale) const;
  [[nodiscard]] SubTask alert_task(const TimeScale& scale) const;
  [[nodiscard]] std::string missing_alert(const TimeScale& scale) const;

  bool has_hallway_;
  std::optional<Deed> in_hallway_;
  std::vector<Room> rooms_;
  std::map<std::uint32_t, Suspect> suspects_;  ///< By object.
  std::optional<Deed> found_;                  ///< The real object, for the first time.
  std::uint32_t found_in_ = 0;                 ///< Number of its room; 0 for none.
  std::optional<Deed> alerted_;                ///< After that.
  std::optional<Deed> false_alarm_;            ///< Before that.
};

}  // namespace tacit
