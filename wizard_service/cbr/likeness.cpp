#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "idl/types/random.h"
#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/store.h"

namespace tacit::cbr {
namespace {

using cdl::Expression;
using Kind = Expression::Kind;

/// 128 bits that stand for a list of texts and numbers, each of its own length.
class Digest {
 public:
  Digest& add(std::uint64_t number) {
    mix({static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32U), 1, 0});
    return *this;
  }
  Digest& add(std::string_view text) {
    add(text.size());
    for (std::size_t begin = 0; begin < text.size(); begin += 16) {
      PhiloxBlock block{};
      for (std::size_t i = 0; i < 16 && begin + i < text.size(); ++i) {
        block[i / 4] |= std::uint32_t{static_cast<unsigned char>(text[begin + i])} << (i % 4 * 8);
      }
      mix(block);
    }
    return *this;
  }
  [[nodiscard]] std::string text() const {
    std::string digits;
    for (const std::uint32_t word : state_) {
      for (unsigned shift = 32; shift > 0; shift -= 4) {
        digits += "0123456789abcdef"[word >> (shift - 4U) & 15U];
      }
    }
    return digits;
  }

 private:
  void mix(const PhiloxBlock& block) {
    for (std::size_t i = 0; i < block.size(); ++i) state_[i] ^= block[i];
    state_ = philox(state_, kKey);
    for (std::size_t i = 0; i < block.size(); ++i) state_[i] ^= block[i];
  }

  static constexpr std::uint64_t kKey = 0x6c696b656e657373;
  PhiloxBlock state_{};
};

/// What an expression says, whatever its labels and places are, and whether it is shared or not.
class Sayings {
 public:
  explicit Sayings(const Plan& plan) {
    for (const cdl::Statement& one : plan.shared) shared_[one.name].body = &one.body;
  }

  std::string of(const Expression& expression) {
    switch (expression.kind) {
      case Kind::Nothing:
        return "-";
      case Kind::Value:
        return '{' + expression.name;
      case Kind::Reference:
        return of_name(expression.name);
      case Kind::Instance:
      case Kind::Group:
      case Kind::Rule:
        return of_list(expression);
    }
    return {};
  }

 private:
  struct Shared {
    const Expression* body = nullptr;
    std::string saying;
    bool begun = false;
  };

  std::string of_name(const std::string& name) {
    const auto found = shared_.find(name);
    if (found == shared_.end()) return '=' + name;
    Shared& shared = found->second;
    if (!shared.begun) {
      shared.begun = true;  // One that refers to itself says nothing more.
      shared.saying = of(*shared.body);
    }
    return shared.saying;
  }

  std::string of_list(const Expression& list) {
    if (list.kind == Kind::Group && list.items.size() == 1 && !list.items.front().slot) {
      return of(list.items.front().value);
    }
    std::vector<std::string> named;
    std::vector<std::string> others;
    for (const cdl::Item& item : list.items) {
      std::vector<std::string>& where = item.slot ? named : others;
      where.push_back(of_item(item));
    }
    std::sort(named.begin(), named.end());
    Digest digest;
    digest.add(static_cast<std::uint64_t>(list.kind)).add(list.name).add(named.size());
    for (const std::string& one : named) digest.add(one);
    for (const std::string& one : others) digest.add(one);
    return digest.text();
  }

  std::string of_item(const cdl::Item& item) {
    if (!item.slot) return of(item.value);
    return Digest()
        .add(item.slot->name)
        .add(item.slot->is_parameter ? 1 : 0)
        .add(item.slot->index.value_or(""))
        .add(of(item.value))
        .text();
  }

  std::map<std::string, Shared, std::less<>> shared_;
};

/// Numbers the states of one automaton in the order in which rules lead to them. States that
/// nothing leads out of and that do the same are one.
class Numbering {
 public:
  Numbering(const RobotPlan& robot, Sayings& sayings) : sayings_(sayings) {
    for (const PlanState& state : robot.states) states_.emplace(state.name, &state);
    (void)number(entry_of(robot));
  }

  void add_to(Digest& digest) {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const PlanState& state = *order_[i];
      digest.add(sayings_.of(state.behaviour)).add(state.rules.size());
      for (const PlanRule& rule : state.rules) {
        digest.add(sayings_.of(rule.trigger)).add(number(rule.target));
      }
    }
    digest.add(order_.size());
  }

 private:
  std::uint64_t number(const std::string& name) {
    const auto state = states_.find(name);
    if (state == states_.end()) return ~std::uint64_t{0};
    const auto [known, is_new] = numbers_.emplace(name, order_.size());
    if (!is_new) return known->second;
    if (state->second->rules.empty()) {
      const auto [end, is_first] =
          ends_.emplace(sayings_.of(state->second->behaviour), order_.size());
      known->second = end->second;
      if (!is_first) return known->second;
    }
    order_.push_back(state->second);
    return known->second;
  }

  Sayings& sayings_;
  std::map<std::string, const PlanState*, std::less<>> states_;
  std::map<std::string, std::uint64_t> numbers_;
  std::map<std::string, std::uint64_t> ends_;  ///< By what is done there.
  std::vector<const PlanState*> order_;
};

}  // namespace

std::string likeness(const Plan& plan) {
  Sayings sayings(plan);
  Digest digest;
  for (const RobotPlan& robot : plan.robots) {
    digest.add(robot.type);
    Numbering(robot, sayings).add_to(digest);
  }
  return digest.text();
}

}  // namespace tacit::cbr
