#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wizard_service/cbr/plan.h"

namespace tacit::cbr {

/// The name of the state that an automaton begins in.
inline constexpr std::string_view kStart = "Start";

/// Null when there is none of that name.
[[nodiscard]] const PlanState* find_state(const RobotPlan& robot, std::string_view name);
[[nodiscard]] PlanState* find_state(RobotPlan& robot, std::string_view name);

/// The name of the state in which a part does something at last: that behind Start when Start is
/// but a Stop that an Immediate leads out of.
[[nodiscard]] std::string entry_of(const RobotPlan& part);

/// Whether the robot's part is over in it: Terminate, TerminateMission, and a Stop that nothing
/// leads out of.
[[nodiscard]] bool is_end(const PlanState& state);

/// Whether the whole mission is over in it.
[[nodiscard]] bool ends_for_all(const PlanState& state);

/// Whether the part can come to an end, or to one for all, by its own rules.
[[nodiscard]] bool ends_by_itself(const RobotPlan& part);
[[nodiscard]] bool ends_for_all(const RobotPlan& part);

/// The states that rules lead to from `from`, with it, in the automaton's order.
[[nodiscard]] std::vector<const PlanState*> reachable_from(const RobotPlan& robot,
                                                           std::string_view from);

/// The first of `$AN_1`, `$AN_2`, … that no state has.
[[nodiscard]] std::string fresh_name(const RobotPlan& robot);

/// "LookFor (Survey)", or the name alone of a state without a label.
[[nodiscard]] std::string told(const PlanState& state);

/// "1.5, 2", in the shortest digits that are exact to a centimetre.
[[nodiscard]] std::string place_text(double x_m, double y_m);
/// Rounded to hundredths, in the shortest digits.
[[nodiscard]] std::string number_text(double value);

}  // namespace tacit::cbr
