#include "robot_agent/brain/learning/q_learner.h"

#include <algorithm>
#include <utility>

#include "idl/types/config_error.h"
#include "idl/types/shortest.h"

namespace tacit {

std::size_t QTable::greedy(std::size_t state) const {
  const auto values = row(state);
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

QLearner::QLearner(const Shape& shape, const Config& config, Chance chance)
    : config_(config), exploration_(chance.exploration) {
  table_.actions = shape.actions;
  table_.q.resize(shape.states * shape.actions);
  table_.visits.resize(table_.q.size());
  table_.alpha = config.alpha;
  table_.epsilon = config.epsilon;
  for (double& value : table_.q) {
    value = chance.initial.uniform(config.initial_low, config.initial_high);
  }
}

std::size_t QLearner::query(std::size_t state, double reward) {
  std::size_t action = table_.greedy(state);
  if (config_.learning) {
    if (last_) learn(*last_, reward + config_.gamma * table_.row(state)[action]);
    if (exploration_.uniform() < table_.epsilon) action = exploration_.below(table_.actions);
    ++table_.visits[state * table_.actions + action];
  }
  last_ = {state, action};
  return action;
}

void QLearner::learn(const Choice& choice, double target) {
  const std::size_t before = table_.greedy(choice.state);
  double& value = table_.q[choice.state * table_.actions + choice.action];
  value += table_.alpha * (target - value);
  ++table_.updates;
  if (table_.greedy(choice.state) != before) ++table_.policy_changes;
}

void QLearner::inherit(QTable table) {
  table_ = std::move(table);
  if (!config_.learning) return;
  table_.alpha *= config_.alpha_decay;
  table_.epsilon *= config_.epsilon_decay;
  ++table_.runs;
}

void QLearner::resume(QTable table, const std::optional<Choice>& last,
                      std::uint64_t exploration_position) {
  table_ = std::move(table);
  last_ = last;
  exploration_.seek(exploration_position);
}

void describe(QLearner::Config& config, ParameterVisitor& visitor) {
  constexpr Range kShare{0.0, 1.0};
  constexpr Range kValue{-1e6, 1e6};
  visitor.number("alpha", config.alpha, kShare,
                 {"", "Learning rate of a robot's first run [MissionLab]."});
  visitor.number("alpha_decay", config.alpha_decay, kShare,
                 {"", "Factor of the learning rate from run to run [MissionLab]."});
  visitor.number("epsilon", config.epsilon, kShare,
                 {"", "Chance of a random role at each query, in the first run [MissionLab]."});
  visitor.number("epsilon_decay", config.epsilon_decay, kShare,
                 {"", "Factor of that chance from run to run [MissionLab]."});
  visitor.number("gamma", config.gamma, {0.0, 0.9999},
                 {"", "Discount of what is to come, below 1 [MissionLab]."});
  visitor.number("initial_low", config.initial_low, kValue,
                 {"", "Lower bound of the values that a table begins with [MissionLab]."});
  visitor.number("initial_high", config.initial_high, kValue,
                 {"",
                  "Upper bound of them; above what no reward brings, so that every role gets "
                  "its try [MissionLab]."});
  visitor.flag("learning", config.learning,
               {"",
                "Whether to learn and explore; if not, the best known role is played and the "
                "table stays as it is [ours: to evaluate a policy]."});
}

void check(const QLearner::Config& config) {
  if (config.initial_low <= config.initial_high) return;
  throw ConfigError("brain.q.initial_low is " + shortest(config.initial_low) +
                    ", wanted at most brain.q.initial_high, which is " +
                    shortest(config.initial_high));
}

}  // namespace tacit
