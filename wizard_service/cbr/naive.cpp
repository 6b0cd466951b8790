#include "wizard_service/cbr/naive.h"

#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {

Plan naive_plan(const PlanRequest& request) {
  RobotPlan robot;
  robot.max_mps = request.max_velocity_mps;
  robot.base_mps = request.max_velocity_mps * request.aggressiveness;
  robot.states.push_back({std::string(kStart), "Start", behaviour("Stop"), {}});
  cdl::Expression trigger = behaviour("Immediate");
  for (const PlacedTask& task : request.tasks) {
    const std::string name = "$AN_" + std::to_string(robot.states.size());
    const std::string goal = place_text(task.x_m, task.y_m);
    robot.states.back().rules.push_back({trigger, name});
    robot.states.push_back({name,
                            "To" + std::string(word(task.task)),
                            behaviour("GoTo", {{"Goal_Location", goal}}),
                            {}});
    trigger = behaviour("AtGoal", {{"Goal_Location", goal}, {"Goal_Tolerance", "0.5"}});
  }
  const std::string end = "$AN_" + std::to_string(robot.states.size());
  robot.states.back().rules.push_back({trigger, end});
  robot.states.push_back({end, "Done", behaviour("Terminate"), {}});
  Plan plan;
  for (int i = 1; i <= request.robots.value_or(1); ++i) {
    robot.name = "Robot" + std::to_string(i);
    plan.robots.push_back(robot);
  }
  return plan;
}

}  // namespace tacit::cbr
