#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "robot_agent/brain/fsa/entry.h"
#include "robot_agent/brain/triggers/at_goal.h"
#include "robot_agent/brain/triggers/detect.h"
#include "robot_agent/brain/triggers/holding.h"
#include "robot_agent/brain/triggers/immediate.h"
#include "robot_agent/brain/triggers/moved.h"
#include "robot_agent/brain/triggers/near.h"
#include "robot_agent/brain/triggers/operated.h"
#include "robot_agent/brain/triggers/sites.h"
#include "robot_agent/brain/triggers/tested.h"
#include "robot_agent/brain/triggers/wait.h"
#include "robot_agent/brain/triggers/words.h"
#include "robot_agent/brain/type_list.h"

namespace tacit {

/// All triggers. A new one needs its file, its test and its name here.
///
/// A trigger `T` has a name `T::kName` and a predicate `holds(around)`, or `holds(around, exit)`
/// when it asks how the behaviour of its state has ended. One that remembers also has
/// `entered(entry)`, called when its state is entered; what it remembers follows from that alone,
/// so that an automaton can be taken up again in the middle of a state.
using TriggerTypes =
    TypeList<Immediate, Detect, NotDetected, Near, AwayFrom, Holding, NotHolding, Wait, Never,
             AtGoal, AtOrSkipGoal, AtGoalInFormation, InRoom, InHallway, AtEndOfHall,
             NotAtEndOfHall, AtDoorway, MarkedDoorway, Notified, MessageSent, Alerted, TaskExited,
             TestPositive, TestNegative, Proceed, SkipGoal, TelopComplete, MovedDistance, HasTurned,
             AboutFaceCompleted, NoProgress>;
using Trigger = TriggerTypes::Variant;

[[nodiscard]] inline bool holds(const Trigger& trigger, const Surroundings& around,
                                std::span<const Word> exit = {}) {
  return std::visit(
      [&](const auto& each) {
        if constexpr (requires { each.holds(around, exit); }) {
          return each.holds(around, exit);
        } else {
          return each.holds(around);
        }
      },
      trigger);
}

/// Tells `trigger` that its state has been entered.
inline void notify_entered(Trigger& trigger, const Entry& entry) {
  std::visit(
      [&entry](auto& each) {
        if constexpr (requires { each.entered(entry); }) each.entered(entry);
      },
      trigger);
}

}  // namespace tacit
