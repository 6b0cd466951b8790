#pragma once

#include <string_view>

#include "idl/cdl/finding.h"
#include "idl/cdl/model.h"

namespace tacit::cdl {

/// What is wrong with a mission that `source` was parsed to, by its place.
///
/// Errors: undefined and duplicate names, names in a circle, an automaton without Start, two states
/// of one name, rules for and to states that are not there, a parameter of the wrong kind, a team
/// too deep or too large and, when there is nothing else, a robot without actuators. Warnings:
/// states that no rule leads to or out of (but for those in which a mission ends: Stop, Terminate,
/// …), behaviours, triggers and parameters that are not in the vocabulary, parameters that nothing
/// above gives, a file without robots. At most kMostFindings of each severity.
[[nodiscard]] Findings check(const Mission& mission, std::string_view source);

/// Parses and checks. The checks need every statement, so errors of the language come alone.
[[nodiscard]] Findings check_text(std::string_view source);

}  // namespace tacit::cdl
