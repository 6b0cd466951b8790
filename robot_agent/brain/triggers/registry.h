#pragma once

#include <string_view>
#include <variant>

#include "robot_agent/brain/triggers/detect.h"
#include "robot_agent/brain/triggers/holding.h"
#include "robot_agent/brain/triggers/immediate.h"
#include "robot_agent/brain/triggers/near.h"
#include "robot_agent/brain/triggers/wait.h"
#include "robot_agent/brain/type_list.h"

namespace tacit {

/// All triggers. A new one needs its file, its test and its name here.
///
/// A trigger `T` has a name `T::kName` and a predicate `holds(around)`. One that remembers also has
/// `entered(now)`, called when its state is entered; what it remembers follows from that tick
/// alone, so that an automaton can be taken up again in the middle of a state.
using TriggerTypes =
    TypeList<Immediate, Detect, NotDetected, Near, AwayFrom, Holding, NotHolding, Wait>;
using Trigger = TriggerTypes::Variant;

[[nodiscard]] inline bool holds(const Trigger& trigger, const Surroundings& around) {
  return std::visit([&around](const auto& each) { return each.holds(around); }, trigger);
}

/// Tells `trigger` that its state has been entered at tick `now`.
inline void notify_entered(Trigger& trigger, Tick now) {
  std::visit(
      [now](auto& each) {
        if constexpr (requires { each.entered(now); }) each.entered(now);
      },
      trigger);
}

}  // namespace tacit
