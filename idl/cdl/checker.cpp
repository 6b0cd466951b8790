#include "idl/cdl/checker.h"

#include <algorithm>
#include <utility>

#include "idl/cdl/check.h"
#include "idl/cdl/parse.h"
#include "idl/cdl/resolve.h"
#include "idl/types/nearest_word.h"

namespace tacit::cdl {
namespace {

using Kind = Expression::Kind;

/// Comparing with every known name takes time; a mission with more findings has other troubles.
constexpr std::size_t kMostHints = 200;
constexpr std::size_t kMostCompared = 1000;
constexpr std::size_t kLongestHinted = 64;

void check_team(const Mission& mission, Findings& findings) {
  Resolved resolved = resolve(mission);
  // An actuator may be missing for no other reason than a name that is not there.
  const bool whole = !has_error(findings);
  for (const Robot& robot : resolved.robots) {
    if (whole && robot.actuators.empty()) {
      findings.push_back({Severity::Error, "no-actuators",
                          "the robot " + robot.name + " has no actuators, nothing can move it",
                          robot.span.begin, 0, 0});
    }
  }
  if (resolved.robots.empty()) {
    findings.push_back({Severity::Warning, "no-robots", "the file has no robots", 0, 0, 0});
  }
  for (Finding& finding : resolved.findings) {
    findings.push_back(std::move(finding));
  }
}

}  // namespace

Findings check(const Mission& mission, std::string_view source) {
  Findings findings = Checker(mission).run();
  check_team(mission, findings);
  locate(findings, source);
  return findings;
}

Findings check_text(std::string_view source) {
  Parsed parsed = parse(source);
  return parsed.findings.empty() ? check(parsed.mission, source) : std::move(parsed.findings);
}

Checker::Checker(const Mission& mission)
    : mission_(mission),
      names_(mission),
      known_names_(names_.first(kMostCompared, kLongestHinted)),
      references_(mission.statements.size()) {}

Findings Checker::run() {
  doubles();
  for (const Statement& statement : mission_.statements) {
    statement_ = static_cast<std::size_t>(&statement - mission_.statements.data());
    const bool is_team = statement.kind == Statement::Kind::Configuration;
    walk(statement.body, is_team ? Wanted::Statement : Wanted::Any);
  }
  circles();
  return findings_.take();
}

void Checker::walk(const Expression& expression, Wanted wanted) {
  if (expression.kind == Kind::Reference) {
    reference(expression, wanted);
  } else if (expression.kind == Kind::Group) {
    parameters(expression, wanted);
  }
  const bool is_automaton = expression.kind == Kind::Instance && expression.name == "FSA";
  if (is_automaton) {
    automaton(expression);
  }
  for (const Item& item : expression.items) {
    Wanted inner = expression.kind == Kind::Instance ? Wanted::Statement : wanted;
    if (item.slot && item.slot->index) {
      const bool is_trigger = item.slot->name == "rules" || item.slot->name == "triggers";
      inner = is_trigger ? Wanted::Trigger : Wanted::Behaviour;
    } else if (item.slot && item.value.kind == Kind::Group) {
      inner = Wanted::Any;
    }
    walk(item.value, inner);
  }
}

void Checker::reference(const Expression& reference, Wanted wanted) {
  if (names_.find(reference.name) != nullptr) {
    references_[statement_].push_back(&reference);
  } else if (wanted == Wanted::Statement || reference.name.starts_with('$')) {
    undefined(reference);
  } else {
    unknown(reference, wanted);
  }
}

void Checker::undefined(const Expression& reference) {
  find(Severity::Error, "undefined-name",
       "nothing is called " + reference.name + hint(reference.name, known_names_), reference.span);
}

void Checker::unknown(const Expression& reference, Wanted wanted) {
  static const std::vector<std::string> kBehaviours = words_for(Use::Behaviour);
  static const std::vector<std::string> kTriggers = words_for(Use::Trigger);
  const bool behaviour =
      wanted != Wanted::Trigger && !parameters_of(reference.name, Use::Behaviour).empty();
  const bool trigger =
      wanted != Wanted::Behaviour && !parameters_of(reference.name, Use::Trigger).empty();
  if (behaviour || trigger) {
    return;
  }
  const auto& words = wanted == Wanted::Trigger ? kTriggers : kBehaviours;
  find(Severity::Warning, wanted == Wanted::Trigger ? "unknown-trigger" : "unknown-behaviour",
       "the " + std::string(wanted == Wanted::Trigger ? "trigger " : "behaviour ") +
           reference.name + " is not known" + hint(reference.name, words),
       reference.span);
}

void Checker::parameters(const Expression& group, Wanted wanted) {
  const Expression* body = body_of(group);
  if (body == nullptr || body->kind != Kind::Reference || names_.find(body->name) != nullptr) {
    return;
  }
  std::span<const VocabularyRow> known;
  if (wanted != Wanted::Trigger) {
    known = parameters_of(body->name, Use::Behaviour);
  }
  if (known.empty() && wanted != Wanted::Behaviour) {
    known = parameters_of(body->name, Use::Trigger);
  }
  for (const Item& item : group.items) {
    if (item.slot && !known.empty() && !known.front().parameter.empty()) {
      parameter(item, *body, known);
    }
  }
}

void Checker::parameter(const Item& item, const Expression& body,
                        std::span<const VocabularyRow> known) {
  const std::string& name = item.slot->name;
  const auto row = std::find_if(known.begin(), known.end(),
                                [&](const VocabularyRow& one) { return one.parameter == name; });
  if (row == known.end()) {
    std::vector<std::string> names;
    for (const VocabularyRow& one : known) {
      names.emplace_back(one.parameter);
    }
    find(Severity::Warning, "unknown-parameter",
         body.name + " has no parameter " + name + hint(name, names), item.span);
    return;
  }
  if (item.value.kind != Kind::Value) {
    return;
  }
  const Value value = parse_value(item.value.name);
  if (const std::optional<std::string> wanted = misfit(*row, value)) {
    const bool far = row->kind == ParameterKind::Number && std::holds_alternative<double>(value);
    find(far ? Severity::Warning : Severity::Error, far ? "out-of-range" : "wrong-kind",
         name + " of " + body.name + " is " +
             (far ? "{" + item.value.name + "}" : describe(value)) + ", wanted " + *wanted,
         item.value.span);
  }
}

std::string Checker::hint(std::string_view name, const std::vector<std::string>& known) const {
  const bool hinted = findings_.size() < kMostHints && name.size() <= kLongestHinted;
  return hinted ? did_you_mean(name, known) : "";
}

void Checker::find(Severity severity, const char* rule, std::string text, const Span& span) {
  findings_.add({severity, rule, std::move(text), span.begin, 0, 0});
}

}  // namespace tacit::cdl
