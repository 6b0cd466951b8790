#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/mission/arguments.h"

namespace tacit {

/// Who a robot is among those of its mission.
struct TeamPlace {
  std::size_t number = 0;  ///< From 0.
  std::size_t count = 1;
};

/// The behaviours that missions name, as states without name and rules. Gains, spheres and margins
/// are the mission's, else MissionLab's defaults. All that move keep off obstacles and robots and
/// follow the operator's joystick beside what they do.
namespace behaviours {

// Moving: move.cpp.
/// To a point of the map (MissionLab's GoTo: MoveTo + AvoidObstacles + Noise).
[[nodiscard]] StatePlan go_to(const Arguments& given);
/// The same with gains that follow progress (GoTo_LM).
[[nodiscard]] StatePlan go_to_lm(const Arguments& given);
/// To the nearest thing of some classes (MoveToward).
[[nodiscard]] StatePlan move_toward(const Arguments& given);
[[nodiscard]] StatePlan move_toward_lm(const Arguments& given);
/// Away from it (MoveAway).
[[nodiscard]] StatePlan move_away(const Arguments& given);
/// As `move_toward`, at a distance (Follow, StayWith).
[[nodiscard]] StatePlan follow(const Arguments& given);
/// Straight on (MoveAhead, MoveForward).
[[nodiscard]] StatePlan move_ahead(const Arguments& given);
/// About: noise, open ground and obstacles (Wander).
[[nodiscard]] StatePlan wander(const Arguments& given);
/// To a point in line, column, wedge or diamond (MoveInFormation).
[[nodiscard]] StatePlan move_in_formation(const Arguments& given, const TeamPlace& place);
/// As the joystick says (Telop).
[[nodiscard]] StatePlan telop(const Arguments& given);
/// On the spot until it faces the other way (AboutFace), or on and on (Spin).
[[nodiscard]] StatePlan about_face(const Arguments& given);
[[nodiscard]] StatePlan spin(const Arguments& given);
/// Stands still (Stop, Localize, WaitForProceed).
[[nodiscard]] StatePlan stop(const Arguments& given);

// In buildings: rooms.cpp.
[[nodiscard]] StatePlan proceed_along_hallway(const Arguments& given);
[[nodiscard]] StatePlan enter_room(const Arguments& given);
[[nodiscard]] StatePlan leave_room(const Arguments& given);
[[nodiscard]] StatePlan go_through_door(const Arguments& given);
[[nodiscard]] StatePlan mark_doorway(const Arguments& given);
[[nodiscard]] StatePlan unmark_doorway(const Arguments& given);
/// Goes to every suspect thing in sight and tests it; ends when one is dangerous or none is left
/// (SurveyRoom*, an automaton of its own).
[[nodiscard]] StatePlan survey_room(const Arguments& given);

// With things: objects.cpp.
/// Turns on the spot to look about (LookFor).
[[nodiscard]] StatePlan look_for(const Arguments& given);
[[nodiscard]] StatePlan pick_up(const Arguments& given);
[[nodiscard]] StatePlan put_in_eod(const Arguments& given);
[[nodiscard]] StatePlan test_object(const Arguments& given);
[[nodiscard]] StatePlan terminate_object(const Arguments& given);

// With others and the operator: signals.cpp.
/// Gives a signal, once (Notify, NotifyRobots).
[[nodiscard]] StatePlan notify(const Arguments& given);
[[nodiscard]] StatePlan alert(const Arguments& given);
/// Waits for the operator's word, then ends (Standby*).
[[nodiscard]] StatePlan standby(const Arguments& given);
/// Goes to where a part of the mission begins (StartSubMission).
[[nodiscard]] StatePlan start_sub_mission(const Arguments& given);
[[nodiscard]] StatePlan exit_task(const Arguments& given);
[[nodiscard]] StatePlan terminate(const Arguments& given);
[[nodiscard]] StatePlan terminate_mission(const Arguments& given);

}  // namespace behaviours

/// What a mission calls `word`; null when it is not known. Those that need a place in the team
/// get it from `place`.
using BehaviourMaker = StatePlan (*)(const Arguments& given, const TeamPlace& place);
[[nodiscard]] BehaviourMaker behaviour_called(std::string_view word);
/// All that are known.
[[nodiscard]] std::vector<std::string> behaviours_known();

}  // namespace tacit
