#include "deploy/lockstep/compose_operation.h"

#include <cmath>
#include <utility>

#include "deploy/lockstep/place_names.h"
#include "deploy/lockstep/start_places.h"
#include "idl/overlay/check.h"
#include "idl/overlay/plan.h"
#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "robot_agent/brain/mission/compile.h"

namespace tacit {
namespace {

MapPlan read_plan(const NamedText& map) {
  const OverlayReading reading = read_overlay(map.text);
  MapFindings findings = reading.findings;
  const MapFindings more = check(reading.map);
  findings.insert(findings.end(), more.begin(), more.end());
  refuse_errors(findings, map.name);
  return plan_of(reading.map, Doors::Open);
}

/// The first place on the map that a robot's states lead it to; map frame.
std::optional<WorldVec> first_goal(const StatePlan& state) {
  const auto goal_of = [](const SchemaUse& use) -> std::optional<WorldVec> {
    if (const auto* place = std::get_if<MoveToPlace::Config>(&use.setting)) return place->goal_m;
    return std::nullopt;
  };
  if (state.momentum) return goal_of(state.momentum->goal);
  for (const SchemaUse& use : state.activity.schemas) {
    if (const auto goal_m = goal_of(use)) return goal_m;
  }
  if (!state.nested) return std::nullopt;
  for (const StatePlan& inner : state.nested->states) {
    if (const auto goal_m = first_goal(inner)) return goal_m;
  }
  return std::nullopt;
}

/// Puts robots on the map, one after the other.
class Placing {
 public:
  explicit Placing(const MapPlan& plan)
      : shift_m_(plan.ground.shift_m.x_m, plan.ground.shift_m.y_m), places_(plan) {}

  void put(const std::vector<double>& row) {
    static_cast<void>(places_.take(WorldVec{row[0], row[1]} + shift_m_));
    rows_.push_back(row);
  }

  void put_team(const std::vector<RobotPlan>& team, const std::vector<std::vector<double>>& given) {
    for (std::size_t i = 0; i < team.size(); ++i) {
      if (i < given.size()) {
        put(given[i]);
        continue;
      }
      const auto goal_m = goal_of(team[i]);
      const WorldVec start_m = places_.team_m();
      const Heading way = places_.facing(start_m, goal_m);
      // One behind the other, a metre apart, the first at the head.
      const auto behind = static_cast<double>(team.size() - 1 - i);
      stand(start_m + behind * WorldVec{way.cos, way.sin}, goal_m, team[i].name);
    }
  }

  void put_extras(const std::vector<RobotPlan>& extras,
                  const std::vector<std::vector<double>>& given) {
    for (std::size_t i = 0; i < extras.size(); ++i) {
      if (i < given.size()) {
        put(given[i]);
        continue;
      }
      const auto goal_m = goal_of(extras[i]);
      if (!goal_m) {
        throw ConfigError("extra robot " + extras[i].name +
                          " has no goal to start from; wanted its start as x,y or x,y,heading");
      }
      stand(*goal_m, std::nullopt, extras[i].name);
    }
  }

  [[nodiscard]] std::vector<std::vector<double>>& rows() { return rows_; }

 private:
  [[nodiscard]] std::optional<WorldVec> goal_of(const RobotPlan& robot) const {
    const auto goal_m = first_goal(robot.root);
    return goal_m ? std::optional(*goal_m + shift_m_) : std::nullopt;
  }

  void stand(const WorldVec& wanted_m, const std::optional<WorldVec>& goal_m,
             const std::string& name) {
    const auto place_m = places_.take(wanted_m);
    if (!place_m) {
      throw ConfigError("the map has no room for robot " + name + " to start");
    }
    const Heading way = places_.facing(*place_m, goal_m);
    const WorldVec on_map_m = *place_m - shift_m_;
    const double heading_deg = std::round(way.rad() * (180.0 / kPi) * 10.0) / 10.0;
    rows_.push_back({on_map_m.x(), on_map_m.y(), heading_deg});
  }

  WorldVec shift_m_;
  StartPlaces places_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace

OperationScript compose_operation(const OperationWish& wish) {
  const MapPlan plan = read_plan(wish.map);
  OperationScript script;
  script.map = wish.map.text;
  script.mission = with_places(wish.mission.text, wish.mission.name, plan);
  std::vector<RobotPlan> team = compile_mission(script.mission, wish.mission.name);
  if (wish.robots && *wish.robots != team.size()) {
    script.mission = with_robots(script.mission, wish.mission.name, *wish.robots);
    team = compile_mission(script.mission, wish.mission.name);
  }
  Placing placing(plan);
  placing.put_team(team, wish.starts);
  if (wish.extras) {
    script.extras = with_places(wish.extras->text, wish.extras->name, plan);
    script.extra_colour = wish.extra_colour;
    const std::vector<RobotPlan> extras = compile_mission(script.extras, wish.extras->name);
    script.extra_count = static_cast<std::int64_t>(extras.size());
    placing.put_extras(extras, wish.extra_starts);
  }
  script.starts = std::move(placing.rows());
  return script;
}

}  // namespace tacit
