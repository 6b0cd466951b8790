#include "robot_agent/brain/forage_mind.h"

#include "robot_agent/brain/learning/heterogeneous.h"
#include "robot_agent/brain/learning/homogeneous.h"
#include "robot_agent/brain/learning/policy_text.h"
#include "robot_agent/brain/learning/q_roles.h"
#include "robot_agent/brain/roles/role_plans.h"

namespace tacit {
namespace {

std::unique_ptr<RoleSelector> make_selector(const BrainConfig& config, const Self& self) {
  if (config.learner == "homogeneous") return std::make_unique<Homogeneous>();
  if (config.learner == "heterogeneous") {
    return std::make_unique<Heterogeneous>(config.heterogeneous, self.robot);
  }
  return std::make_unique<QRoles>(config.q, self);
}

std::vector<Automaton> make_automata(const BrainConfig& config, const Self& self) {
  std::vector<Automaton> automata;
  for (const AutomatonPlan& plan : role_plans(config.roles)) {
    automata.emplace_back(plan, config.schemas, self);
  }
  return automata;
}

}  // namespace

ForageMind::ForageMind(const BrainConfig& config, const Self& self)
    : robot_(self.robot),
      learner_name_(config.learner),
      ranges_(config.q.ranges),
      selector_(make_selector(config, self)),
      perception_(std::get<AvoidSoldiers::Config>(config.schemas).reach_m, config.pursuit),
      automata_(make_automata(config, self)),
      actuator_(config.actuator) {}

Command ForageMind::decide(const Percept& percept) {
  const Surroundings& around = perception_.look(percept);
  tick_ = percept.tick;
  const Doing doing = around.able ? act(around) : Doing{};
  disabled_ = !around.able;
  const BodyVec velocity_mps = actuator_.velocity_mps(doing.sum);
  return {robot_, tick_, velocity_mps, actuator_.turn_radps(velocity_mps), doing.act};
}

Doing ForageMind::act(const Surroundings& around) {
  triggers_ = role_triggers(around, ranges_);
  const Role role = selector_->choose({around, triggers_, disabled_});
  const bool goes_on = role_ == role && !disabled_;
  role_ = role;
  if (goes_on) return automaton(role).step(around);
  automaton(role).enter({around.tick, around.odometry});
  return {};
}

void ForageMind::report(Telemetry& out) const {
  out.robot = robot_;
  out.tick = tick_;
  out.learner = learner_name_;
  out.situation.clear();
  out.role.clear();
  out.state.clear();
  out.shares.clear();
  if (!role_ || disabled_) return;
  out.situation = words(triggers_);
  out.role = name(*role_);
  out.state = automaton(*role_).state();
  automaton(*role_).report(out.shares);
}

// The first line says where the run stands; the policy follows.
std::string ForageMind::memory(std::string_view policy) const {
  return to_line(stand()).append("\n").append(policy);
}

RunStand ForageMind::stand() const {
  RunStand stand;
  stand.learner = learner_name_;
  if (role_) {
    stand.role = name(*role_);
    stand.state = automaton(*role_).state();
    stand.entered = automaton(*role_).entered();
  }
  stand.disabled = disabled_;
  stand.perception = perception_.memory();
  selector_->note(stand);
  return stand;
}

bool ForageMind::recall(std::string_view memory) {
  const std::size_t end = memory.find('\n');
  if (end == std::string_view::npos) return false;
  const auto stand = parse_stand(memory.substr(0, end));
  if (!stand || !knows(*stand)) return false;
  if (!selector_->resume(*stand, memory.substr(end + 1))) return false;
  perception_.resume(stand->perception);
  role_ = role_called(stand->role);
  if (role_) automaton(*role_).resume(stand->state, stand->entered);
  disabled_ = stand->disabled;
  return true;
}

bool ForageMind::knows(const RunStand& stand) const {
  if (stand.learner != learner_name_ || !perception_.fits(stand.perception)) return false;
  if (stand.role.empty()) return stand.state.empty();
  const auto role = role_called(stand.role);
  return role && automaton(*role).has(stand.state);
}

}  // namespace tacit
