#include "idl/cdl/vocabulary.h"

#include <algorithm>
#include <array>

namespace tacit::cdl {
namespace {

constexpr Use kB = Use::Behaviour;
constexpr Use kT = Use::Trigger;
constexpr ParameterKind kNumber = ParameterKind::Number;
constexpr ParameterKind kPoint = ParameterKind::Point;
constexpr ParameterKind kWord = ParameterKind::Word;
constexpr ParameterKind kWords = ParameterKind::Words;
constexpr ParameterKind kText = ParameterKind::Text;

// Words, parameters and units are MissionLab's. Defaults are those of its library where they are
// known and else what its missions give. `curious` and `cautious` have the range of its sliders;
// all other ranges are ours and only catch slips: a gain above 10, a distance above 1000 m.
// clang-format off
constexpr VocabularyRow kRows[] = {
    {"AboutFace", kB, "", kWord, "", "", 0, 0},
    {"Alert", kB, "alert_subject", kText, "", "", 0, 0},
    {"Alert", kB, "alert_message", kText, "", "", 0, 0},
    {"Alert", kB, "sends_email", kWord, "", "NO_Email", 0, 0},
    {"Alert", kB, "recipient", kText, "", "\"\"", 0, 0},
    {"ChangeRobotColor", kB, "", kWord, "", "", 0, 0},
    {"EnterRoom", kB, "enter_room_gain", kNumber, "", "1.0", 0, 10},
    {"EnterRoom", kB, "distance_to_enter", kNumber, "m", "1.0", 0, 1000},
    {"EnterRoom", kB, "enter_which", kWord, "", "ENTER_UNMARKED_ONLY", 0, 0},
    {"EnterRoom", kB, "avoid_obstacles_gain", kNumber, "", "0.33", 0, 10},
    {"EnterRoom", kB, "avoid_obstacle_sphere", kNumber, "m", "0.5", 0, 1000},
    {"EnterRoom", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"EnterAlternateHallway", kB, "", kWord, "", "", 0, 0},
    {"ExitTask", kB, "notify_message", kText, "", "", 0, 0},
    {"Follow", kB, "Objects", kWords, "", "", 0, 0},
    {"Follow", kB, "move_to_object_gain", kNumber, "", "1.0", 0, 10},
    {"Follow", kB, "avoid_obstacle_gain", kNumber, "", "0.5", 0, 10},
    {"Follow", kB, "avoid_obstacle_sphere", kNumber, "m", "1.2", 0, 1000},
    {"Follow", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"Follow", kB, "wander_gain", kNumber, "", "0.0", 0, 10},
    {"Follow", kB, "max_sensor_range", kNumber, "m", "50", 0, 1000},
    {"Follow", kB, "follow_distance", kNumber, "m", "1.0", 0, 1000},
    {"FollowCMDLiCommands", kB, "env_filename", kText, "", "", 0, 0},
    {"FollowCMDLiCommands", kB, "cmdl_filename", kText, "", "", 0, 0},
    {"FollowCMDLiCommands", kB, "move_to_location_gain", kNumber, "", "1.0", 0, 10},
    {"FollowCMDLiCommands", kB, "wander_gain", kNumber, "", "0.0", 0, 10},
    {"FollowCMDLiCommands", kB, "avoid_obstacle_gain", kNumber, "", "0.03", 0, 10},
    {"FollowCMDLiCommands", kB, "avoid_obstacle_sphere", kNumber, "m", "1.5", 0, 1000},
    {"FollowCMDLiCommands", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.5", 0, 1000},
    {"FollowCMDLiCommands", kB, "goal_tolerance", kNumber, "m", "1.0", 0, 1000},
    {"GoThroughDoor", kB, "go_through_door_gain", kNumber, "", "1.0", 0, 10},
    {"GoThroughDoor", kB, "avoid_obstacles_gain", kNumber, "", "0.33", 0, 10},
    {"GoThroughDoor", kB, "avoid_obstacle_sphere", kNumber, "m", "0.5", 0, 1000},
    {"GoThroughDoor", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"GoTo", kB, "Goal_Location", kPoint, "m", "", 0, 0},
    {"GoTo", kB, "move_to_location_gain", kNumber, "", "1.0", 0, 10},
    {"GoTo", kB, "wander_gain", kNumber, "", "0.0", 0, 10},
    {"GoTo", kB, "avoid_obstacle_gain", kNumber, "", "1.0", 0, 10},
    {"GoTo", kB, "avoid_obstacle_sphere", kNumber, "m", "3.0", 0, 1000},
    {"GoTo", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.5", 0, 1000},
    {"GoTo_CBR", kB, "", kWord, "", "", 0, 0},
    {"GoTo_LM", kB, "Goal_Location", kPoint, "m", "", 0, 0},
    {"GoTo_LM", kB, "move_to_goal_gain", kNumber, "", "1.0", 0, 10},
    {"GoTo_LM", kB, "avoid_obstacle_gain", kNumber, "", "1.0", 0, 10},
    {"GoTo_LM", kB, "avoid_obstacle_sphere", kNumber, "m", "3.0", 0, 1000},
    {"GoTo_LM", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.5", 0, 1000},
    {"GoTo_LM", kB, "noise_gain", kNumber, "", "0.0", 0, 10},
    {"GoTo_Dstar", kB, "", kWord, "", "", 0, 0},
    {"GoToOutdoorNavigation", kB, "", kWord, "", "", 0, 0},
    {"GoToSoundSource", kB, "avoid_obstacle_gain", kNumber, "", "0.5", 0, 10},
    {"GoToSoundSource", kB, "avoid_obstacle_sphere", kNumber, "m", "0.69", 0, 1000},
    {"GoToSoundSource", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.34", 0, 1000},
    {"LeaveRoom", kB, "leave_room_gain", kNumber, "", "1.0", 0, 10},
    {"LeaveRoom", kB, "avoid_obstacles_gain", kNumber, "", "0.33", 0, 10},
    {"LeaveRoom", kB, "avoid_obstacle_sphere", kNumber, "m", "0.5", 0, 1000},
    {"LeaveRoom", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"Localize", kB, "New_Location", kPoint, "m", "", 0, 0},
    {"Localize", kB, "New_Heading", kNumber, "deg", "0.0", -360, 360},
    {"LOS_GoTo", kB, "Goal_Location", kPoint, "m", "", 0, 0},
    {"LOS_GoTo", kB, "move_to_location_gain", kNumber, "", "1.0", 0, 10},
    {"LOS_GoTo", kB, "avoid_obstacle_gain", kNumber, "", "1.0", 0, 10},
    {"LOS_GoTo", kB, "avoid_obstacle_sphere", kNumber, "m", "1.0", 0, 1000},
    {"LOS_GoTo", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"LOS_GoTo", kB, "Objects", kWords, "", "", 0, 0},
    {"LookFor", kB, "Objects", kWords, "", "", 0, 0},
    {"Mark", kB, "", kWord, "", "", 0, 0},
    {"MarkDoorway", kB, "", kWord, "", "", 0, 0},
    {"UnmarkDoorway", kB, "", kWord, "", "", 0, 0},
    {"MoveAhead", kB, "move_ahead_gain", kNumber, "", "1.0", 0, 10},
    {"MoveAhead", kB, "direction", kNumber, "deg", "0.0", -360, 360},
    {"MoveAhead", kB, "avoid_obstacle_gain", kNumber, "", "0.5", 0, 10},
    {"MoveAhead", kB, "avoid_obstacle_sphere", kNumber, "m", "1.2", 0, 1000},
    {"MoveAhead", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"MoveForward", kB, "move_ahead_gain", kNumber, "", "1.0", 0, 10},
    {"MoveForward", kB, "direction", kNumber, "deg", "0.0", -360, 360},
    {"MoveForward", kB, "avoid_obstacle_gain", kNumber, "", "0.5", 0, 10},
    {"MoveForward", kB, "avoid_obstacle_sphere", kNumber, "m", "1.2", 0, 1000},
    {"MoveForward", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"MoveInFormation", kB, "Goal_Location", kPoint, "m", "", 0, 0},
    {"MoveInFormation", kB, "formation", kWord, "", "Line", 0, 0},
    {"MoveInFormation", kB, "spacing", kNumber, "m", "20.0", 0, 1000},
    {"MoveInFormation", kB, "dead_zone", kNumber, "m", "0.5", 0, 1000},
    {"MoveInFormation", kB, "saturation", kNumber, "m", "5.0", 0.001, 1000},
    {"MoveInFormation", kB, "move_to_location_gain", kNumber, "", "1.0", 0, 10},
    {"MoveInFormation", kB, "maintain_formation_gain", kNumber, "", "1.0", 0, 10},
    {"MoveInFormation", kB, "avoid_obstacle_gain", kNumber, "", "1.0", 0, 10},
    {"MoveInFormation", kB, "avoid_obstacle_sphere", kNumber, "m", "2.2", 0, 1000},
    {"MoveInFormation", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"Notify", kB, "notify_message", kText, "", "", 0, 0},
    {"MoveAway", kB, "Objects", kWords, "", "", 0, 0},
    {"MoveAway", kB, "move_away_object_gain", kNumber, "", "1.0", 0, 10},
    {"MoveAway", kB, "avoid_obstacle_gain", kNumber, "", "0.5", 0, 10},
    {"MoveAway", kB, "wander_gain", kNumber, "", "0.1", 0, 10},
    {"MoveAway", kB, "avoid_objects_sphere", kNumber, "m", "", 0, 1000},
    {"MoveAway", kB, "avoid_objects_safety_margin", kNumber, "m", "0.0", 0, 1000},
    {"MoveAway", kB, "avoid_obstacle_sphere", kNumber, "m", "1.2", 0, 1000},
    {"MoveAway", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"MoveTo", kB, "Objects", kWords, "", "", 0, 0},
    {"MoveTo", kB, "move_to_object_gain", kNumber, "", "1.0", 0, 10},
    {"MoveTo", kB, "avoid_obstacle_gain", kNumber, "", "1.0", 0, 10},
    {"MoveTo", kB, "avoid_obstacle_sphere", kNumber, "m", "2.2", 0, 1000},
    {"MoveTo", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"MoveTo", kB, "wander_gain", kNumber, "", "0.0", 0, 10},
    {"MoveTo", kB, "max_sensor_range", kNumber, "m", "50", 0, 1000},
    {"MoveToward", kB, "Objects", kWords, "", "", 0, 0},
    {"MoveToward", kB, "move_to_object_gain", kNumber, "", "1.0", 0, 10},
    {"MoveToward", kB, "avoid_obstacle_gain", kNumber, "", "1.0", 0, 10},
    {"MoveToward", kB, "wander_gain", kNumber, "", "0.0", 0, 10},
    {"MoveToward", kB, "avoid_obstacle_sphere", kNumber, "m", "2.2", 0, 1000},
    {"MoveToward", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"MoveToward", kB, "max_sensor_range", kNumber, "m", "50", 0, 1000},
    {"MoveToward_LM", kB, "Objects", kWords, "", "", 0, 0},
    {"MoveToward_LM", kB, "move_to_object_gain", kNumber, "", "1.0", 0, 10},
    {"MoveToward_LM", kB, "avoid_obstacle_gain", kNumber, "", "1.0", 0, 10},
    {"MoveToward_LM", kB, "avoid_obstacle_sphere", kNumber, "m", "3.0", 0, 1000},
    {"MoveToward_LM", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.5", 0, 1000},
    {"MoveToward_LM", kB, "wander_gain", kNumber, "", "0.0", 0, 10},
    {"MoveToward_LM", kB, "max_sensor_range", kNumber, "m", "50", 0, 1000},
    {"NotifyRobots", kB, "notify_message", kText, "", "", 0, 0},
    {"PickUp", kB, "Objects", kWords, "", "", 0, 0},
    {"ProceedAlongHallway", kB, "proceed_direction", kWord, "", "Facing", 0, 0},
    {"ProceedAlongHallway", kB, "move_to_location_gain", kNumber, "", "1.0", 0, 10},
    {"ProceedAlongHallway", kB, "off_path_gain", kNumber, "", "1.0", 0, 10},
    {"ProceedAlongHallway", kB, "avoid_obstacle_gain", kNumber, "", "0.33", 0, 10},
    {"ProceedAlongHallway", kB, "avoid_obstacle_sphere", kNumber, "m", "0.7", 0, 1000},
    {"ProceedAlongHallway", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"PutInEOD", kB, "Object", kWords, "", "", 0, 0},
    {"PutInEOD", kB, "Objects", kWords, "", "", 0, 0},
    {"ResetWorld", kB, "", kWord, "", "", 0, 0},
    {"SetFlag", kB, "", kWord, "", "", 0, 0},
    {"ClearFlag", kB, "", kWord, "", "", 0, 0},
    {"SetRobotColorId", kB, "Cid", kWord, "", "", 0, 0},
    {"Spin", kB, "", kWord, "", "", 0, 0},
    {"Standby*", kB, "", kWord, "", "", 0, 0},
    {"StartSubMission", kB, "Goal_Location", kPoint, "m", "", 0, 0},
    {"StartSubMission", kB, "move_to_location_gain", kNumber, "", "1.0", 0, 10},
    {"StartSubMission", kB, "wander_gain", kNumber, "", "0.0", 0, 10},
    {"StartSubMission", kB, "avoid_obstacle_gain", kNumber, "", "1.0", 0, 10},
    {"StartSubMission", kB, "avoid_obstacle_sphere", kNumber, "m", "2.2", 0, 1000},
    {"StartSubMission", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"StayWith", kB, "Objects", kWords, "", "", 0, 0},
    {"StayWith", kB, "move_to_object_gain", kNumber, "", "1.0", 0, 10},
    {"StayWith", kB, "avoid_obstacle_gain", kNumber, "", "0.5", 0, 10},
    {"StayWith", kB, "avoid_obstacle_sphere", kNumber, "m", "1.2", 0, 1000},
    {"StayWith", kB, "avoid_obstacle_safety_margin", kNumber, "m", "0.3", 0, 1000},
    {"StayWith", kB, "wander_gain", kNumber, "", "0.0", 0, 10},
    {"StayWith", kB, "max_sensor_range", kNumber, "m", "50", 0, 1000},
    {"StayWith", kB, "follow_distance", kNumber, "m", "1.0", 0, 1000},
    {"Stop", kB, "", kWord, "", "", 0, 0},
    {"SurveyRoom*", kB, "", kWord, "", "", 0, 0},
    {"Talk", kB, "", kWord, "", "", 0, 0},
    {"Telop", kB, "", kWord, "", "", 0, 0},
    {"AssistedGoTo", kB, "", kWord, "", "", 0, 0},
    {"Terminate", kB, "", kWord, "", "", 0, 0},
    {"TerminateMission", kB, "", kWord, "", "", 0, 0},
    {"TerminateObject", kB, "Object", kWords, "", "", 0, 0},
    {"TestObject", kB, "Objects", kWords, "", "", 0, 0},
    {"WaitForProceed", kB, "", kWord, "", "", 0, 0},
    {"Wander", kB, "curious", kNumber, "", "0.8", 0, 1},
    {"Wander", kB, "cautious", kNumber, "", "0.5", 0, 1},
    {"WanderRoom*", kB, "", kWord, "", "", 0, 0},
    {"AboutFaceCompleted", kT, "", kWord, "", "", 0, 0},
    {"Alerted", kT, "", kWord, "", "", 0, 0},
    {"AtDoorway", kT, "direction", kWord, "", "", 0, 0},
    {"AtDoorway", kT, "detect_which", kWord, "", "DETECT_UNMARKED_ONLY", 0, 0},
    {"AtDoorway", kT, "Robot_Clearance", kNumber, "m", "0.5", 0, 1000},
    {"AtDoorway", kT, "Hallway_Width", kNumber, "m", "2.0", 0, 1000},
    {"AtEndOfHall", kT, "Goal_Tolerance", kNumber, "m", "0.5", 0, 1000},
    {"NotAtEndOfHall", kT, "Goal_Tolerance", kNumber, "m", "0.5", 0, 1000},
    {"AtGoal", kT, "Goal_Tolerance", kNumber, "m", "0.5", 0, 1000},
    {"AtGoal", kT, "Goal_Location", kPoint, "m", "", 0, 0},
    {"AtGoalInFormation", kT, "Goal_Tolerance", kNumber, "m", "0.5", 0, 1000},
    {"AtGoalInFormation", kT, "Goal_Location", kPoint, "m", "", 0, 0},
    {"AtOrSkipGoal", kT, "Goal_Tolerance", kNumber, "m", "0.5", 0, 1000},
    {"AtOrSkipGoal", kT, "Goal_Location", kPoint, "m", "", 0, 0},
    {"AwayFrom", kT, "Objects", kWords, "", "", 0, 0},
    {"AwayFrom", kT, "Distance", kNumber, "m", "", 0, 1000},
    {"AwayFrom", kT, "measured_to", kWord, "", "Surface", 0, 0},
    {"Detect", kT, "Objects", kWords, "", "", 0, 0},
    {"Detect", kT, "max_sensor_range", kNumber, "m", "50", 0, 1000},
    {"NotDetected", kT, "Objects", kWords, "", "", 0, 0},
    {"NotDetected", kT, "max_sensor_range", kNumber, "m", "50", 0, 1000},
    {"UnDetect", kT, "Objects", kWords, "", "", 0, 0},
    {"UnDetect", kT, "max_sensor_range", kNumber, "m", "50", 0, 1000},
    {"DetectAlternateHallway", kT, "", kWord, "", "", 0, 0},
    {"DetectSound", kT, "Volume_threshold", kNumber, "", "", 0, 1000},
    {"FirstTime", kT, "", kWord, "", "", 0, 0},
    {"FlagIsSet", kT, "", kWord, "", "", 0, 0},
    {"FlagIsClear", kT, "", kWord, "", "", 0, 0},
    {"HasTurned", kT, "Angle", kNumber, "deg", "90.0", 0, 180},
    {"Holding", kT, "Objects", kWords, "", "", 0, 0},
    {"NotHolding", kT, "Objects", kWords, "", "", 0, 0},
    {"Immediate", kT, "", kWord, "", "", 0, 0},
    {"InHallway", kT, "", kWord, "", "", 0, 0},
    {"InRoom", kT, "", kWord, "", "", 0, 0},
    {"InAlternateHallway", kT, "", kWord, "", "", 0, 0},
    {"IsFacing", kT, "", kWord, "", "", 0, 0},
    {"MarkedDoorway", kT, "", kWord, "", "", 0, 0},
    {"UnmarkedDoorway", kT, "", kWord, "", "", 0, 0},
    {"MessageSent", kT, "", kWord, "", "", 0, 0},
    {"MovedDistance", kT, "Desired_distance", kNumber, "m", "", 0, 1000},
    {"Near", kT, "Objects", kWords, "", "", 0, 0},
    {"Near", kT, "Distance", kNumber, "m", "", 0, 1000},
    {"Near", kT, "measured_to", kWord, "", "Surface", 0, 0},
    {"Never", kT, "", kWord, "", "", 0, 0},
    {"NoProgress", kT, "Distance", kNumber, "m", "0.1", 0, 1000},
    {"NoProgress", kT, "Delay", kNumber, "s", "5.0", 0, 10},
    {"Notified", kT, "notify_message", kText, "", "", 0, 0},
    {"Proceed", kT, "", kWord, "", "", 0, 0},
    {"SigSense", kT, "Signal", kWord, "", "", 0, 0},
    {"SkipGoal", kT, "", kWord, "", "", 0, 0},
    {"SubMissionReady", kT, "Goal_Tolerance", kNumber, "m", "0.5", 0, 1000},
    {"SubMissionReady", kT, "Goal_Location", kPoint, "m", "", 0, 0},
    {"TaskExited", kT, "notify_message", kText, "", "", 0, 0},
    {"TelopComplete", kT, "", kWord, "", "", 0, 0},
    {"TestPositive", kT, "", kWord, "", "", 0, 0},
    {"TestNegative", kT, "", kWord, "", "", 0, 0},
    {"ThroughDoorway", kT, "", kWord, "", "", 0, 0},
    {"Wait", kT, "Delay", kNumber, "s", "1.0", 0, 86400},
};
// clang-format on

std::string shown(double number) {
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

std::string wanted(const VocabularyRow& row) {
  switch (row.kind) {
    case ParameterKind::Number:
      return "a number from " + shown(row.low) + " to " + shown(row.high) +
             (row.unit.empty() ? "" : " " + std::string(row.unit));
    case ParameterKind::Point:
      return "a point: x, y in " + std::string(row.unit) + ", or the name of one";
    case ParameterKind::Flag:
      return "true or false";
    case ParameterKind::Word:
      return "a word";
    case ParameterKind::Words:
      return "words, such as Mines | Robots";
    case ParameterKind::Text:
      return "a text in quotation marks";
  }
  return {};
}

bool fits(const VocabularyRow& row, const Value& value) {
  switch (row.kind) {
    case ParameterKind::Number: {
      const double* number = std::get_if<double>(&value);
      return number != nullptr && row.low <= *number && *number <= row.high;
    }
    case ParameterKind::Point: {
      // MissionLab's later versions have a height as well; a name is that of a point of the map.
      const auto* list = std::get_if<std::vector<double>>(&value);
      const auto* name = std::get_if<Words>(&value);
      return (list != nullptr && (list->size() == 2 || list->size() == 3)) ||
             (name != nullptr && name->words.size() == 1);
    }
    case ParameterKind::Flag:
      return std::holds_alternative<bool>(value);
    case ParameterKind::Word: {
      const Words* words = std::get_if<Words>(&value);
      return words != nullptr && words->words.size() == 1;
    }
    case ParameterKind::Words:
      return std::holds_alternative<Words>(value);
    case ParameterKind::Text:
      return std::holds_alternative<QuotedText>(value);
  }
  return false;
}

}  // namespace

std::span<const VocabularyRow> vocabulary() { return kRows; }

std::span<const VocabularyRow> parameters_of(std::string_view word, Use use) {
  const auto is_it = [&](const VocabularyRow& row) { return row.word == word && row.use == use; };
  const auto* begin = std::find_if(std::begin(kRows), std::end(kRows), is_it);
  return {begin, std::find_if_not(begin, std::end(kRows), is_it)};
}

std::vector<std::string> words_for(Use use) {
  std::vector<std::string> words;
  for (const VocabularyRow& row : kRows) {
    if (row.use == use && (words.empty() || words.back() != row.word)) {
      words.emplace_back(row.word);
    }
  }
  return words;
}

std::optional<std::string> misfit(const VocabularyRow& row, const Value& value) {
  if (std::holds_alternative<FromAbove>(value) || fits(row, value)) {
    return std::nullopt;
  }
  return wanted(row);
}

}  // namespace tacit::cdl
