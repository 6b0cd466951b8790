#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "idl/cdl/model.h"

namespace tacit::cdl {

/// What the statements of a mission are called. Does not outlive the mission.
class Names {
 public:
  explicit Names(const Mission& mission);

  /// The first statement of that name, or null.
  [[nodiscard]] const Statement* find(std::string_view name) const;
  /// Statements whose name an earlier one has.
  [[nodiscard]] std::vector<const Statement*> doubles() const;
  /// The first names in order, each once, at most so many and none of more letters.
  [[nodiscard]] std::vector<std::string> first(std::size_t most, std::size_t longest) const;

 private:
  std::vector<const Statement*> by_name_;
};

/// The item of a list that has a slot of this name, or null.
[[nodiscard]] const Item* find_slot(const Expression& list, std::string_view name);

/// The first item without a slot: what a group is about. Null when there is none.
[[nodiscard]] const Expression* body_of(const Expression& group);

}  // namespace tacit::cdl
