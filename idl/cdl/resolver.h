#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "idl/cdl/names.h"
#include "idl/cdl/resolve.h"

namespace tacit::cdl {

/// Parameters that are offered to what is inside, and those around them.
struct Scope {
  const Scope* around = nullptr;
  const std::vector<Parameter>* offered = nullptr;
};

/// Turns expressions into parts of a team. Used once.
///
/// Whatever walks a list, up the scopes or down a reference spends steps first and makes nothing
/// when there are none left.
class Resolver {
 public:
  explicit Resolver(const Mission& mission);

  [[nodiscard]] Resolved run();

 private:
  void robots(const Expression& team, int depth);
  void robot(const Expression& bound, int depth);
  void devices(const Expression& list, Robot& robot, int depth);
  void device(const Expression& point, Robot& robot, int depth);

  Behaviour behaviour(const Expression& expression, const Scope& scope, int depth);
  Behaviour of_group(const Expression& group, const Scope& scope, int depth);
  Behaviour of_reference(const Expression& reference, const Scope& scope, int depth);
  Behaviour of_instance(const Expression& instance, const Scope& scope, int depth);
  Automaton automaton(const Expression& instance, const Scope& scope, int depth);
  WeightedSum weighted_sum(const Expression& instance, const Scope& scope, int depth);
  Learner learner(const Expression& instance, const Scope& scope, int depth);
  std::vector<Member> members(const Expression& instance, std::string_view slot, const Scope& scope,
                              int depth);
  Member member(const Item& item, const Scope& scope, int depth);

  std::vector<Parameter> parameters(const Expression& list, const Scope& scope);
  const Parameter* look_up(const Scope& scope, std::string_view name, const Span& span);
  Value effective(const Item& item, const Scope& scope);
  /// What stands at the end of a chain of names; null for a name that is no statement's.
  const Expression* followed(const Expression& reference);
  const Item* slot_of(const Expression& list, std::string_view name);
  bool too_deep(int depth, const Span& span);
  bool spend(std::size_t steps, const Span& span);
  void find(Severity severity, const char* rule, const std::string& text, const Span& span);

  const Mission& mission_;
  Names names_;
  std::vector<Robot> robots_;
  FindingList findings_;
  std::set<std::pair<std::uint32_t, std::string_view>> found_;  ///< Places and rules, each once.
  std::uint64_t steps_left_;
};

}  // namespace tacit::cdl
