#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "console/debrief/debrief.h"
#include "idl/overlay/reader.h"

namespace tacit {

inline MapPlan plan_in(const std::string& text) {
  return plan_of(read_overlay(text).map, Doors::Open);
}

/// Three rooms on a hallway, the last of them without a door.
inline const std::string kHouse =
    "MISSION-AREA 40 20\n"
    "HALLWAY \"h\" CENTERLINE 0 10 40 10 WIDTH 2 EXTENTS 0 9 40 9 40 11 0 11\n"
    "ROOM \"East\" 20 0 40 0 40 9 20 9\n"
    "DOOR \"d1\" 25 9 26 9\n"
    "ROOM \"West\" 0 0 20 0 20 9 0 9\n"
    "GAP \"d2\" 5 9.1 5 8.9 1\n"
    "ROOM \"Shut\" 0 11 40 11 40 20 0 20\n";
inline constexpr std::uint32_t kEast = 1;
inline constexpr std::uint32_t kWest = 2;
inline constexpr std::uint32_t kShut = 3;

/// Rock 1, fixed suspect 2 in the west, real suspect 3 in the east, suspect 4 behind shut walls.
inline const std::string kSuspects =
    "OBJECT 1 1 0.5 FIXED black\n"
    "OBJECT 3 3 0.5 FIXED \"brown\"\n"
    "OBJECT 30 3 0.5 MOVABLE Brown\n"
    "OBJECT 30 15 0.5 FIXED brown\n";

/// Events that follow each other, told tick by tick.
class Story {
 public:
  explicit Story(const std::string& map, const Debrief::Config& config = {})
      : debrief_(plan_in(map), config) {}

  Story& at(Tick tick) {
    tick_ = tick;
    return *this;
  }
  Story& tell(Happening what) {
    debrief_.add({tick_, std::move(what)});
    return *this;
  }
  Story& enters(std::uint16_t robot, std::uint32_t room) {
    return tell(SiteEntered{{robot}, Site::Room, room});
  }
  Story& in_hallway(std::uint16_t robot) { return tell(SiteEntered{{robot}, Site::Hallway, 1}); }
  Story& says(std::uint16_t robot, const char* word) {
    return tell(Signalled{{robot}, Word(word), 1});
  }
  Story& tests(std::uint16_t robot, std::uint32_t object, Finding finding = Finding::Harmless) {
    return tell(ObjectTested{{robot}, {object}, finding});
  }
  Story& alerts(std::uint16_t robot) { return tell(Alerted{{robot}, Word("Found.")}); }
  Story& seen(std::uint16_t robot, std::uint16_t by) {
    return tell(RobotExposed{{robot}, {by}, true});
  }

  [[nodiscard]] Checklist list() const { return debrief_.result(); }
  /// None when it is not wanted.
  [[nodiscard]] std::optional<SubTask> task(const std::string& name) const {
    const Checklist all = list();
    const auto found = std::find_if(all.tasks.begin(), all.tasks.end(),
                                    [&name](const SubTask& task) { return task.name == name; });
    return found == all.tasks.end() ? std::nullopt : std::optional(*found);
  }
  /// "done", "missing" or "not wanted".
  [[nodiscard]] std::string verdict(const std::string& name) const {
    const std::optional<SubTask> found = task(name);
    return !found ? "not wanted" : found->done ? "done" : "missing";
  }

 private:
  Debrief debrief_;
  Tick tick_ = 0;
};

}  // namespace tacit
