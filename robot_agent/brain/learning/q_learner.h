#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "idl/types/parameters.h"
#include "idl/types/random.h"

namespace tacit {

/// What a Q-learner knows, and how far it has got.
struct QTable {
  std::size_t actions = 0;
  std::vector<double> q;              ///< Row by row: a state's actions lie side by side.
  std::vector<std::uint64_t> visits;  ///< How often each action was chosen in each state.
  double alpha = 0.0;                 ///< Learning rate, as it stands.
  double epsilon = 0.0;               ///< Chance of a random action, as it stands.
  std::uint64_t runs = 1;             ///< That learned in it, the present one included.
  std::uint64_t updates = 0;
  std::uint64_t policy_changes = 0;  ///< Updates that changed a state's best action.

  [[nodiscard]] std::size_t states() const { return q.size() / actions; }
  [[nodiscard]] std::span<const double> row(std::size_t state) const {
    return std::span(q).subspan(state * actions, actions);
  }
  /// The first of the best actions in `state`.
  [[nodiscard]] std::size_t greedy(std::size_t state) const;
  friend bool operator==(const QTable&, const QTable&) = default;
};

/// Tabular Q-learning (Watkins) as MissionLab's QLEARN has it: optimistic start, uniform
/// exploration, and a learning and an exploration rate that decay once per run.
class QLearner {
 public:
  struct Config {
    double alpha = 0.1;
    double alpha_decay = 0.9;
    double epsilon = 0.1;
    double epsilon_decay = 1.0;
    double gamma = 0.8;
    double initial_low = 1.0;
    double initial_high = 2.0;
    bool learning = true;  ///< False: the table stays as it is, and the best action is taken.
  };
  struct Shape {
    std::size_t states = 0;
    std::size_t actions = 0;
  };
  /// What was decided last.
  struct Choice {
    std::size_t state = 0;
    std::size_t action = 0;
    friend bool operator==(const Choice&, const Choice&) = default;
  };
  /// The streams that the first table and exploration are drawn from.
  struct Chance {
    Stream initial;
    Stream exploration;
  };

  QLearner(const Shape& shape, const Config& config, Chance chance);

  /// Credits `reward` and the prospects of `state` to the last choice, and chooses anew.
  [[nodiscard]] std::size_t query(std::size_t state, double reward);

  [[nodiscard]] const QTable& table() const { return table_; }
  [[nodiscard]] const std::optional<Choice>& last() const { return last_; }
  [[nodiscard]] std::uint64_t exploration_position() const { return exploration_.position(); }

  /// Begins a run with what an earlier one learned; the rates decay. The shape stays the same.
  void inherit(QTable table);
  /// Goes on in the middle of a run.
  void resume(QTable table, const std::optional<Choice>& last, std::uint64_t exploration_position);

 private:
  void learn(const Choice& choice, double target);

  Config config_;
  QTable table_;
  Stream exploration_;
  std::optional<Choice> last_;
};

/// In the visitor's present section.
void describe(QLearner::Config& config, ParameterVisitor& visitor);

/// Throws ConfigError when the initial values' bounds are the wrong way round.
void check(const QLearner::Config& config);

}  // namespace tacit
