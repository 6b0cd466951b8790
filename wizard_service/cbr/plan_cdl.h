#pragma once

#include <string>
#include <string_view>

#include "idl/cdl/model.h"
#include "wizard_service/cbr/plan.h"

namespace tacit::cbr {

/// The plan that a mission is: of each robot the automaton that drives its wheels. Throws
/// ConfigError, naming `name`, when the text is no mission, when it has errors, or when a robot is
/// driven by anything else than one automaton.
[[nodiscard]] Plan plan_of(std::string_view mission, std::string_view name);

/// The mission that a plan is, ready to be printed, checked and run.
[[nodiscard]] cdl::Mission mission_of(const Plan& plan);

/// Its text, with `comment` at its head; reads back to an equal plan.
[[nodiscard]] std::string mission_text(const Plan& plan, std::string_view comment = {});

/// The name of the behaviour or trigger that an expression stands for: `GoTo`; that of a group that
/// it refers to; empty when there is none.
[[nodiscard]] std::string behaviour_name(const cdl::Expression& expression);

/// The text between the braces of the parameter that is called so, without the `%`; null when it
/// has none.
[[nodiscard]] const std::string* parameter(const cdl::Expression& expression,
                                           std::string_view name);
/// Sets it, in place or as a new one in front of the behaviour's name.
void set_parameter(cdl::Expression& expression, std::string_view name, std::string_view value);

/// `[%name = {value}, …, behaviour]`.
struct Given {
  std::string_view name;
  std::string value;
};
[[nodiscard]] cdl::Expression behaviour(std::string_view name, std::vector<Given> parameters = {});

}  // namespace tacit::cbr
