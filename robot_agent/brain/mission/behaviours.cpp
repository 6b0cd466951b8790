#include "robot_agent/brain/mission/behaviours.h"

#include <algorithm>
#include <array>

namespace tacit {
namespace {

struct Known {
  std::string_view word;
  BehaviourMaker make;
};

template <StatePlan (*Make)(const Arguments&)>
StatePlan alone(const Arguments& given, const TeamPlace& /*place*/) {
  return Make(given);
}

// The words are MissionLab's. A new behaviour needs its function, its test and its line here.
constexpr std::array kBehaviours{
    Known{"AboutFace", alone<behaviours::about_face>},
    Known{"Alert", alone<behaviours::alert>},
    Known{"EnterRoom", alone<behaviours::enter_room>},
    Known{"ExitTask", alone<behaviours::exit_task>},
    Known{"Follow", alone<behaviours::follow>},
    Known{"GoThroughDoor", alone<behaviours::go_through_door>},
    Known{"GoTo", alone<behaviours::go_to>},
    Known{"GoTo_LM", alone<behaviours::go_to_lm>},
    Known{"LeaveRoom", alone<behaviours::leave_room>},
    Known{"Localize", alone<behaviours::stop>},
    Known{"LookFor", alone<behaviours::look_for>},
    Known{"MarkDoorway", alone<behaviours::mark_doorway>},
    Known{"MoveAhead", alone<behaviours::move_ahead>},
    Known{"MoveAway", alone<behaviours::move_away>},
    Known{"MoveForward", alone<behaviours::move_ahead>},
    Known{"MoveInFormation", behaviours::move_in_formation},
    Known{"MoveTo", alone<behaviours::move_toward>},
    Known{"MoveToward", alone<behaviours::move_toward>},
    Known{"MoveToward_LM", alone<behaviours::move_toward_lm>},
    Known{"Notify", alone<behaviours::notify>},
    Known{"NotifyRobots", alone<behaviours::notify>},
    Known{"PickUp", alone<behaviours::pick_up>},
    Known{"ProceedAlongHallway", alone<behaviours::proceed_along_hallway>},
    Known{"PutInEOD", alone<behaviours::put_in_eod>},
    Known{"Spin", alone<behaviours::spin>},
    Known{"Standby*", alone<behaviours::standby>},
    Known{"StartSubMission", alone<behaviours::start_sub_mission>},
    Known{"StayWith", alone<behaviours::follow>},
    Known{"Stop", alone<behaviours::stop>},
    Known{"SurveyRoom*", alone<behaviours::survey_room>},
    Known{"Telop", alone<behaviours::telop>},
    Known{"Terminate", alone<behaviours::terminate>},
    Known{"TerminateMission", alone<behaviours::terminate_mission>},
    Known{"TerminateObject", alone<behaviours::terminate_object>},
    Known{"TestObject", alone<behaviours::test_object>},
    Known{"UnmarkDoorway", alone<behaviours::unmark_doorway>},
    Known{"WaitForProceed", alone<behaviours::stop>},
    Known{"Wander", alone<behaviours::wander>},
};

}  // namespace

BehaviourMaker behaviour_called(std::string_view word) {
  const auto* found = std::find_if(kBehaviours.begin(), kBehaviours.end(),
                                   [word](const Known& each) { return each.word == word; });
  return found == kBehaviours.end() ? nullptr : found->make;
}

std::vector<std::string> behaviours_known() {
  std::vector<std::string> words;
  for (const Known& each : kBehaviours) words.emplace_back(each.word);
  return words;
}

}  // namespace tacit
