#pragma once

#include <string>

#include "wizard_service/cbr/plan.h"

namespace tacit::cbr {

/// Whether a rule is for an enemy in sight.
[[nodiscard]] bool sees_enemies(const PlanRule& rule);

/// What the robots of a team say when they see an enemy, as a parameter's text, quotes included:
/// the word of a NotifyRobots that such a rule leads to. Empty for one robot, and for a team of
/// which none says anything then.
[[nodiscard]] std::string warning_of(const Plan& team);

/// The name of the state in which a robot begins its part when it has been warned on the way: what
/// it does about an enemy in sight when it begins, else the part's entry.
[[nodiscard]] std::string warned_entry_of(const RobotPlan& part);

}  // namespace tacit::cbr
