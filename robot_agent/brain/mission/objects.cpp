#include "robot_agent/brain/mission/behaviours.h"
#include "robot_agent/brain/mission/parts.h"

namespace tacit::behaviours {
namespace {

/// MissionLab writes %Objects in some missions and %Object in others.
ThingSet objects(const Arguments& given) {
  return given.things(given.has("Object") ? "Object" : "Objects");
}

}  // namespace

StatePlan look_for(const Arguments& given) {
  static_cast<void>(given.things("Objects"));
  return state_of(standing({}, Turn::Scan));
}

StatePlan pick_up(const Arguments& given) {
  return state_of(standing({.act = Act::PickUp, .about = colour_of(objects(given))}));
}

StatePlan put_in_eod(const Arguments& given) {
  static_cast<void>(objects(given));
  return state_of(standing({.act = Act::Drop}));
}

// MissionLab's probe: a second of waiting, then the result.
StatePlan test_object(const Arguments& given) {
  const bool named = given.has("Object") || given.has("Objects");
  return state_of(standing({.act = Act::Test,
                            .about = named ? colour_of(objects(given)) : std::nullopt,
                            .after_ticks = kProbeTicks}));
}

StatePlan terminate_object(const Arguments& given) {
  static_cast<void>(objects(given));
  return state_of(standing({.act = Act::Intercept}));
}

}  // namespace tacit::behaviours
