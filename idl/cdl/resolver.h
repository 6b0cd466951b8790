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
class Resolver {
 public:
  explicit Resolver(const Mission& mission) : names_(mission) {}

  [[nodiscard]] Resolved run(const Mission& mission);

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
  Value effective(const Item& item, const Scope& scope);
  const Expression* followed(const Expression& reference);
  bool too_much(int depth, const Span& span);
  void find(Severity severity, const char* rule, const std::string& text, const Span& span);

  Names names_;
  Resolved resolved_;
  std::set<std::pair<std::uint32_t, std::string>> found_;
  int parts_ = 0;
};

}  // namespace tacit::cdl
