#include "robot_agent/brain/mission/triggers.h"

#include <algorithm>
#include <array>

namespace tacit {
namespace {

std::optional<Colour> carried(const Arguments& given) {
  return given.has("Objects") ? colour_of(given.things("Objects")) : std::nullopt;
}

Side side_called(const Arguments& given) {
  const std::string word = given.word("direction");
  if (word == "Left") return Side::Left;
  if (word == "Right") return Side::Right;
  if (word != "Either" && word != "Any" && word != "Both") {
    given.refuse("no side is called " + word + ", wanted Left, Right or Either");
  }
  return Side::Either;
}

/// Centre to centre is what the built-in roles of a forager measure.
Measured measured(const Arguments& given) {
  const std::string word = given.word("measured_to");
  if (word != "Surface" && word != "Centre") {
    given.refuse("%measured_to is " + word + ", wanted Surface or Centre");
  }
  return word == "Centre" ? Measured::ToCentre : Measured::ToSurface;
}

bool unmarked_only(const Arguments& given) {
  const std::string which = given.word("detect_which");
  if (which != "DETECT_UNMARKED_ONLY" && which != "DETECT_ANY") {
    given.refuse("%detect_which is " + which + ", wanted DETECT_UNMARKED_ONLY or DETECT_ANY");
  }
  return which != "DETECT_ANY";
}

template <class T>
Trigger plain(const Arguments& /*given*/) {
  return T{};
}

template <class T>
Trigger at_place(const Arguments& given) {
  return T{given.point("Goal_Location"), given.number("Goal_Tolerance")};
}

template <class T>
Trigger in_sight(const Arguments& given) {
  return T{given.things("Objects"), given.number("max_sensor_range")};
}

template <class T>
Trigger at_range(const Arguments& given) {
  return T{given.things("Objects"), given.number("Distance"), measured(given)};
}

template <class T>
Trigger carrying(const Arguments& given) {
  return T{carried(given)};
}

template <class T>
Trigger with_word(const Arguments& given) {
  return T{given.text("notify_message")};
}

template <class T>
Trigger at_end(const Arguments& given) {
  return T{given.number("Goal_Tolerance")};
}

Trigger at_doorway(const Arguments& given) {
  return AtDoorway{side_called(given), unmarked_only(given), given.number("Robot_Clearance"),
                   given.number("Hallway_Width")};
}

Trigger wait(const Arguments& given) { return Wait{given.ticks("Delay"), 0}; }

Trigger moved_distance(const Arguments& given) {
  return MovedDistance{given.number("Desired_distance"), {}};
}

Trigger has_turned(const Arguments& given) { return HasTurned{given.number("Angle"), {}}; }

Trigger no_progress(const Arguments& given) {
  const Tick ticks = given.ticks("Delay");
  if (ticks > 100) given.refuse("%Delay is longer than 10 s");
  return NoProgress{given.number("Distance"), ticks, 0};
}

struct Known {
  std::string_view word;
  Trigger (*make)(const Arguments& given);
};

// The words are MissionLab's. A new trigger needs its type, its test and its line here.
constexpr std::array kTriggers{
    Known{"AboutFaceCompleted", plain<AboutFaceCompleted>},
    Known{"Alerted", plain<Alerted>},
    Known{"AtDoorway", at_doorway},
    Known{"AtEndOfHall", at_end<AtEndOfHall>},
    Known{"AtGoal", at_place<AtGoal>},
    Known{"AtGoalInFormation", at_place<AtGoalInFormation>},
    Known{"AtOrSkipGoal", at_place<AtOrSkipGoal>},
    Known{"AwayFrom", at_range<AwayFrom>},
    Known{"Detect", in_sight<Detect>},
    Known{"FirstTime", plain<Immediate>},
    Known{"HasTurned", has_turned},
    Known{"Holding", carrying<Holding>},
    Known{"Immediate", plain<Immediate>},
    Known{"InHallway", plain<InHallway>},
    Known{"InRoom", plain<InRoom>},
    Known{"MarkedDoorway", plain<MarkedDoorway>},
    Known{"MessageSent", plain<MessageSent>},
    Known{"MovedDistance", moved_distance},
    Known{"Near", at_range<Near>},
    Known{"Never", plain<Never>},
    Known{"NoProgress", no_progress},
    Known{"NotAtEndOfHall", at_end<NotAtEndOfHall>},
    Known{"NotDetected", in_sight<NotDetected>},
    Known{"NotHolding", carrying<NotHolding>},
    Known{"Notified", with_word<Notified>},
    Known{"Proceed", plain<Proceed>},
    Known{"SkipGoal", plain<SkipGoal>},
    Known{"SubMissionReady", at_place<AtOrSkipGoal>},
    Known{"TaskExited", with_word<TaskExited>},
    Known{"TelopComplete", plain<TelopComplete>},
    Known{"TestNegative", plain<TestNegative>},
    Known{"TestPositive", plain<TestPositive>},
    Known{"ThroughDoorway", plain<InRoom>},
    Known{"UnDetect", in_sight<NotDetected>},
    Known{"UnmarkedDoorway", plain<MarkedDoorway>},
    Known{"Wait", wait},
};

}  // namespace

std::optional<Trigger> trigger_called(const Arguments& given) {
  const auto* found = std::find_if(kTriggers.begin(), kTriggers.end(), [&given](const Known& each) {
    return each.word == given.word_of_behaviour();
  });
  if (found == kTriggers.end()) return std::nullopt;
  return found->make(given);
}

std::vector<std::string> triggers_known() {
  std::vector<std::string> words;
  for (const Known& each : kTriggers) words.emplace_back(each.word);
  return words;
}

}  // namespace tacit
