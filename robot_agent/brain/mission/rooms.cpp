#include "robot_agent/brain/mission/behaviours.h"
#include "robot_agent/brain/mission/parts.h"

namespace tacit::behaviours {
namespace {

HallwayWay way_called(const Arguments& given) {
  const std::string word = given.word("proceed_direction");
  if (word == "Left") return HallwayWay::Left;
  if (word == "Right") return HallwayWay::Right;
  if (word != "Facing" && word != "Any") {
    given.refuse("no direction is called " + word + ", wanted Facing, Left or Right");
  }
  return HallwayWay::Facing;
}

bool unmarked_only(const Arguments& given) {
  const std::string which = given.word("enter_which");
  if (which != "ENTER_UNMARKED_ONLY" && which != "ENTER_ANY") {
    given.refuse("%enter_which is " + which + ", wanted ENTER_UNMARKED_ONLY or ENTER_ANY");
  }
  return which != "ENTER_ANY";
}

// MissionLab's words of 2000 and of 2004 for the same.
const std::vector<Word>& found_words() {
  static const std::vector<Word> kWords{Word("TEST POSITIVE"), Word("TARGET FOUND"),
                                        Word("BIOHAZARD FOUND"), Word("BIOHAZARD DETECTED")};
  return kWords;
}
const std::vector<Word>& nothing_words() {
  static const std::vector<Word> kWords{Word("NO BIOHAZARD DETECTED"), Word("NO TARGET FOUND"),
                                        Word("NO BIOHAZARD FOUND")};
  return kWords;
}

StatePlan ending(std::string name, const std::vector<Word>& words) {
  StatePlan state;
  state.name = std::move(name);
  state.activity.exit = words;
  return state;
}

StatePlan named(std::string name, ActivityPlan activity, std::vector<Rule> rules) {
  return {std::move(name), std::move(activity), std::move(rules)};
}

}  // namespace

StatePlan proceed_along_hallway(const Arguments& given) {
  const ProceedAlong::Config along{way_called(given)};
  return state_of(moving({use_of<ProceedAlong>(given.number("move_to_location_gain"), along),
                          {std::string(StayOnPath::kName), given.number("off_path_gain"), {}, {}}},
                         clearance_in(given, "avoid_obstacle_gain"), 0.0));
}

StatePlan enter_room(const Arguments& given) {
  const PassDoorway::Config pass{false, unmarked_only(given), given.number("distance_to_enter")};
  return state_of(moving({use_of<PassDoorway>(given.number("enter_room_gain"), pass)},
                         clearance_in(given, "avoid_obstacles_gain"), 0.0));
}

// Half a hallway's width beyond the doorway, so that the robot is clear of it [ours].
StatePlan leave_room(const Arguments& given) {
  const PassDoorway::Config pass{true, false, 0.8};
  return state_of(moving({use_of<PassDoorway>(given.number("leave_room_gain"), pass)},
                         clearance_in(given, "avoid_obstacles_gain"), 0.0));
}

StatePlan go_through_door(const Arguments& given) {
  const PassDoorway::Config pass{false, false, 1.0};
  return state_of(moving({use_of<PassDoorway>(given.number("go_through_door_gain"), pass)},
                         clearance_in(given, "avoid_obstacles_gain"), 0.0));
}

StatePlan mark_doorway(const Arguments& /*given*/) {
  return state_of(standing({.act = Act::Mark, .once = true}));
}

StatePlan unmark_doorway(const Arguments& /*given*/) {
  return state_of(standing({.act = Act::Unmark, .once = true}));
}

// MissionLab's SurveyRoom*: LookFor, MoveToward (gains 1.0 and 0.5, sphere 1.2, margin 0.3), Near
// 0.1, TestObject, and out with what was found.
StatePlan survey_room(const Arguments& /*given*/) {
  const ThingSet suspects = Thing::UnknownHere;
  const Deed test{.act = Act::Test, .about = Colour::Brown, .after_ticks = kProbeTicks};
  const ActivityPlan approach =
      moving({use_of<MoveTo>(1.0, {}, suspects)}, {0.5, 1.2, 0.3, {}}, 0.0);
  const Near beside{suspects, 0.1, Measured::ToSurface};
  AutomatonPlan plan;
  plan.name = "SurveyRoom*";
  plan.states = {
      named("LookFor", standing({}, Turn::Scan),
            {{Detect{suspects}, "MoveToward"}, {NotDetected{suspects}, "NothingFound"}}),
      named("MoveToward", approach, {{beside, "TestObject"}, {NotDetected{suspects}, "LookFor"}}),
      named("TestObject", standing(test),
            {{TestPositive{}, "Found"},
             {TestNegative{}, "LookFor"},
             {NotDetected{suspects}, "LookFor"}}),
      ending("Found", found_words()),
      ending("NothingFound", nothing_words()),
  };
  StatePlan state;
  state.nested = std::make_shared<const AutomatonPlan>(std::move(plan));
  return state;
}

}  // namespace tacit::behaviours
