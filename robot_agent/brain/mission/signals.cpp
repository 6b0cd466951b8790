#include "robot_agent/brain/mission/behaviours.h"
#include "robot_agent/brain/mission/parts.h"

namespace tacit::behaviours {

StatePlan notify(const Arguments& given) {
  return state_of(
      standing({.act = Act::Signal, .word = given.text("notify_message"), .once = true}));
}

StatePlan alert(const Arguments& given) {
  return state_of(standing({.act = Act::Alert, .word = given.text("alert_subject"), .once = true}));
}

StatePlan standby(const Arguments& /*given*/) {
  StatePlan done;
  done.name = "Done";
  done.activity.exit = {Word("PROCEED MISSION")};
  AutomatonPlan plan;
  plan.name = "Standby*";
  plan.states = {{"Wait", {}, {{Proceed{}, "Done"}}}, done};
  StatePlan state;
  state.nested = std::make_shared<const AutomatonPlan>(std::move(plan));
  return state;
}

// MissionLab's DEPLOY_BY_GOTO: gains 1.0 and 0.3 indoors, 1.0 outdoors.
StatePlan start_sub_mission(const Arguments& given) {
  const Clearance clear = clearance_in(given);
  return state_of(moving(
      {use_of<MoveToPlace>(given.number("move_to_location_gain"), {given.point("Goal_Location")})},
      clear, given.number("wander_gain")));
}

StatePlan exit_task(const Arguments& given) {
  StatePlan state;
  state.activity.exit = {given.text("notify_message")};
  return state;
}

StatePlan terminate(const Arguments& /*given*/) { return state_of(standing({.act = Act::Finish})); }

StatePlan terminate_mission(const Arguments& /*given*/) {
  return state_of(standing({.act = Act::FinishAll}));
}

}  // namespace tacit::behaviours
