#include "robot_agent/brain/fsa/learned_choice.h"

#include "idl/types/config_error.h"
#include "robot_agent/brain/fsa/make_behaviour.h"

namespace tacit {
namespace {

std::size_t states_of(const ChoicePlan& plan) {
  if (plan.actions.empty()) throw ConfigError("learner " + plan.name + " has no actions");
  if (plan.triggers.size() > LearnedChoice::kMostTriggers) {
    throw ConfigError("learner " + plan.name + " has " + std::to_string(plan.triggers.size()) +
                      " triggers, wanted at most " + std::to_string(LearnedChoice::kMostTriggers));
  }
  return plan.actions.size() << plan.triggers.size();
}

void check_reinforcers(const ChoicePlan& plan) {
  const std::size_t states = states_of(plan);
  for (const ChoicePlan::Reinforcer& each : plan.reinforcers) {
    if (each.state.value_or(0) >= states || each.action.value_or(0) >= plan.actions.size()) {
      throw ConfigError("learner " + plan.name + " has a reinforcer for state " +
                        std::to_string(each.state.value_or(0)) + " and action " +
                        std::to_string(each.action.value_or(0)) + ", wanted states below " +
                        std::to_string(states) + " and actions below " +
                        std::to_string(plan.actions.size()));
    }
  }
}

}  // namespace

LearnedChoice::LearnedChoice(const ChoicePlan& plan, const SchemaConfigs& configs, const Self& self)
    : triggers_(plan.triggers),
      reinforcers_(plan.reinforcers),
      action_timeout_(plan.action_timeout),
      learner_({states_of(plan), plan.actions.size()}, plan.learner,
               {Stream(self.seed, "choice table", self.robot.value),
                Stream(self.seed, "choice exploration", self.robot.value)}) {
  check_reinforcers(plan);
  for (const StatePlan& action : plan.actions) {
    names_.push_back(action.name);
    actions_.push_back(make_behaviour(action, configs, self));
  }
}

void LearnedChoice::enter(const Entry& entry) {
  action_ = 0;
  asked_ = false;
  last_query_ = entry.tick;
  actions_[action_]->enter(entry);
  for (Trigger& trigger : triggers_) notify_entered(trigger, entry);
}

std::size_t LearnedChoice::firing(const Surroundings& around) const {
  std::size_t fired = 0;
  for (std::size_t i = 0; i < triggers_.size(); ++i) {
    if (holds(triggers_[i], around, actions_[action_]->exit())) fired |= std::size_t{1} << i;
  }
  return fired;
}

std::size_t LearnedChoice::choose(const Surroundings& around) {
  const std::size_t fired = firing(around);
  const std::size_t state = action_ + actions_.size() * fired;
  std::size_t chosen = action_;
  bool asked = false;
  const auto ask = [&](double reward) {
    chosen = learner_.query(state, reward);
    asked = true;
  };
  for (const ChoicePlan::Reinforcer& each : reinforcers_) {
    const bool matches =
        each.state.value_or(state) == state && each.action.value_or(action_) == action_;
    if (matches) ask(each.reward);
  }
  const bool changed = !asked_ || fired != fired_;
  const bool overdue = around.tick - last_query_ >= action_timeout_;
  if (!asked && (changed || overdue)) ask(0.0);
  fired_ = fired;
  asked_ = true;
  if (asked) last_query_ = around.tick;
  return chosen;
}

Doing LearnedChoice::step(const Surroundings& around) {
  const std::size_t chosen = choose(around);
  if (chosen == action_) return actions_[action_]->step(around);
  action_ = chosen;
  actions_[action_]->enter({around.tick, around.odometry});
  return {};
}

void LearnedChoice::report(std::vector<SchemaShare>& shares) const {
  actions_[action_]->report(shares);
}

void LearnedChoice::name_states(std::string& path) const {
  path.append("/").append(names_[action_]);
  actions_[action_]->name_states(path);
}

void LearnedChoice::begin_run() {
  learner_.inherit(learner_.table());
  for (const auto& action : actions_) action->begin_run();
}

void LearnedChoice::note(Record& record) const {
  record.add_count(action_);
  record.add_count(fired_);
  record.add_count(asked_ ? 1 : 0);
  record.add_count(last_query_);
  const QTable& table = learner_.table();
  for (const double value : table.q) record.add(value);
  for (const std::uint64_t visits : table.visits) record.add_count(visits);
  record.add(table.alpha);
  record.add(table.epsilon);
  record.add_count(table.runs);
  record.add_count(table.updates);
  record.add_count(table.policy_changes);
  record.add_count(learner_.exploration_position());
  const auto& last = learner_.last();
  record.add_count(last ? 1 : 0);
  record.add_count(last ? last->state : 0);
  record.add_count(last ? last->action : 0);
  for (const auto& action : actions_) action->note(record);
}

bool LearnedChoice::resume(RecordReader& record) {
  constexpr std::uint64_t kMost = RecordReader::kMostTicks;
  QTable table = learner_.table();
  const std::size_t action = record.count(actions_.size());
  const std::size_t fired = record.count(std::uint64_t{1} << triggers_.size());
  const bool asked = record.count(2) == 1;
  const Tick last_query = record.count(kMost);
  for (double& value : table.q) value = record.number();
  for (std::uint64_t& visits : table.visits) visits = record.count(kMost);
  table.alpha = record.number();
  table.epsilon = record.number();
  table.runs = record.count(kMost);
  table.updates = record.count(kMost);
  table.policy_changes = record.count(kMost);
  const std::uint64_t exploration = record.count(kMost);
  const bool has_last = record.count(2) == 1;
  const std::size_t last_state = record.count(table.states());
  const std::size_t last_action = record.count(table.actions);
  if (!record.sound()) return false;
  action_ = action;
  fired_ = fired;
  asked_ = asked;
  last_query_ = last_query;
  std::optional<QLearner::Choice> last;
  if (has_last) last = QLearner::Choice{last_state, last_action};
  learner_.resume(std::move(table), last, exploration);
  for (const auto& each : actions_) {
    if (!each->resume(record)) return false;
  }
  return true;
}

}  // namespace tacit
