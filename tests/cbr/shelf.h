#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "wizard_service/cbr/case_index.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr::testing {

inline std::string text_of(const std::string& file) {
  std::ifstream in(std::filesystem::path(TACIT_SOURCE_DIR) / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The shipped missions as cases.
class Shelf final : public CaseSource {
 public:
  Shelf() {
    add("biohazard", Task::Biohazard, false);
    add("biohazard_pair", Task::Biohazard, true);
    add("eod", Task::ExplosiveOrdnance, false);
    for (const int robots : {1, 2}) add_way_points(robots);
  }
  const Case& find(CaseId id) override { return cases_.at(id - 1); }
  [[nodiscard]] CaseIndex index() const {
    std::vector<CaseHead> heads;
    for (const Case& one : cases_) heads.push_back({one.id, one.features, 0});
    return CaseIndex(heads);
  }

 private:
  void add(const std::string& mission, Task task, bool enemy) {
    Case one;
    one.id = cases_.size() + 1;
    one.title = mission;
    one.features = usual_features(task);
    one.features.handles_enemy = enemy;
    one.plan = plan_of(text_of("deploy/missions/" + mission + ".cdl"), mission);
    one.features.robots = static_cast<int>(one.plan.robots.size());
    cases_.push_back(std::move(one));
  }
  /// Being there is all: what brings a robot there comes before the case.
  void add_way_points(int robots) {
    Case one;
    one.id = cases_.size() + 1;
    one.title = "way points";
    one.features = usual_features(Task::Waypoints);
    one.features.robots = robots;
    RobotPlan robot;
    robot.name = "Scout";
    robot.states = {{"Start", "Start", behaviour("Stop"), {{behaviour("Immediate"), "$AN_1"}}},
                    {"$AN_1", "Done", behaviour("Terminate"), {}}};
    one.plan.robots.assign(static_cast<std::size_t>(robots), robot);
    cases_.push_back(std::move(one));
  }
  std::vector<Case> cases_;
};

}  // namespace tacit::cbr::testing
