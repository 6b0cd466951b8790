#include "idl/cdl/names.h"

#include <algorithm>

namespace tacit::cdl {

Names::Names(const Mission& mission) {
  for (const Statement& statement : mission.statements) {
    if (statement.kind == Statement::Kind::Instantiation ||
        statement.kind == Statement::Kind::Definition) {
      by_name_.push_back(&statement);
    }
  }
  std::stable_sort(by_name_.begin(), by_name_.end(),
                   [](const Statement* a, const Statement* b) { return a->name < b->name; });
}

const Statement* Names::find(std::string_view name) const {
  const auto found = std::lower_bound(
      by_name_.begin(), by_name_.end(), name,
      [](const Statement* statement, std::string_view wanted) { return statement->name < wanted; });
  return found != by_name_.end() && (*found)->name == name ? *found : nullptr;
}

std::vector<const Statement*> Names::doubles() const {
  std::vector<const Statement*> doubles;
  for (std::size_t i = 1; i < by_name_.size(); ++i) {
    if (by_name_[i]->name == by_name_[i - 1]->name) {
      doubles.push_back(by_name_[i]);
    }
  }
  return doubles;
}

std::vector<std::string> Names::first(std::size_t most, std::size_t longest) const {
  std::vector<std::string> names;
  for (const Statement* statement : by_name_) {
    const std::string& name = statement->name;
    if (names.size() < most && name.size() <= longest && (names.empty() || names.back() != name)) {
      names.push_back(name);
    }
  }
  return names;
}

const Item* find_slot(const Expression& list, std::string_view name) {
  for (const Item& item : list.items) {
    if (item.slot && item.slot->name == name) {
      return &item;
    }
  }
  return nullptr;
}

const Expression* body_of(const Expression& group) {
  for (const Item& item : group.items) {
    if (!item.slot) {
      return &item.value;
    }
  }
  return nullptr;
}

}  // namespace tacit::cdl
