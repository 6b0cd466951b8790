#include "robot_agent/brain/operation_mind.h"

#include "idl/types/config_error.h"
#include "robot_agent/brain/fsa/make_behaviour.h"
#include "robot_agent/brain/operation_config.h"
#include "robot_agent/brain/operation_memory.h"

namespace tacit {
namespace {

Actuator::Config with_wheels(Actuator::Config config, const Wheels& wheels) {
  config.base_mps = wheels.base_mps.value_or(config.base_mps);
  config.max_mps = wheels.max_mps.value_or(config.max_mps);
  return config;
}

}  // namespace

OperationMind::OperationMind(const BrainConfig& config, const Self& self)
    : robot_(self.robot),
      plan_(robot_plan(config.script, self.robot)),
      perception_(start_of(config.script, self.robot)),
      root_(make_behaviour(plan_.root, config.schemas, Self{self.robot, self.seed, errand_})),
      actuator_(with_wheels(config.actuator, plan_.wheels)),
      cautious_mps_(plan_.wheels.cautious
                        ? plan_.wheels.cautious_mps.value_or(config.actuator.max_mps)
                        : std::numeric_limits<double>::infinity()) {}

Command OperationMind::decide(const Percept& percept) {
  const Surroundings& around = perception_.look(percept);
  tick_ = percept.tick;
  if (!around.able) return {robot_, tick_, {}, 0.0, Act::None, std::nullopt, {}};
  if (begun_) return command(root_->step(around));
  begun_ = true;
  root_->enter({around.tick, around.odometry});
  return command({});
}

Command OperationMind::command(const Doing& doing) const {
  BodyVec velocity_mps = actuator_.velocity_mps(doing.sum);
  if (doing.hemmed_in) velocity_mps = clipped(velocity_mps, cautious_mps_);
  const double turn_radps = doing.turn_rad ? actuator_.turn_by_radps(*doing.turn_rad)
                                           : actuator_.turn_radps(velocity_mps);
  return {robot_, tick_, velocity_mps, turn_radps, doing.act, doing.about, doing.word};
}

void OperationMind::report(Telemetry& out) const {
  out.robot = robot_;
  out.tick = tick_;
  out.learner = "mission";
  out.situation.clear();
  out.role = plan_.name.substr(0, Telemetry::kMaxName);
  std::string path;
  if (begun_) root_->name_states(path);
  out.state = path.empty() ? path : path.substr(1);
  if (out.state.size() > Telemetry::kMaxName) {
    // The innermost state says most.
    out.state = out.state.substr(out.state.size() - Telemetry::kMaxName);
  }
  out.shares.clear();
  if (begun_) root_->report(out.shares);
}

// What QLEARN operators and momentum have learned cannot be told apart from where they stand.
std::string OperationMind::policy() const {
  OperationStand stand;
  stand.begun = begun_;
  stand.perception = perception_.memory();
  stand.proceeded = errand_->proceeded;
  if (begun_) root_->note(stand.record);
  return to_text(stand);
}

bool OperationMind::recall(std::string_view memory) {
  const auto stand = parse_operation_stand(memory);
  if (!stand) return false;
  RecordReader record(stand->record.values());
  if (stand->begun && (!root_->resume(record) || !record.at_end())) return false;
  begun_ = stand->begun;
  perception_.resume(stand->perception);
  errand_->proceeded = stand->proceeded;
  return true;
}

void OperationMind::inherit(std::string_view policy, std::string_view name) {
  if (!recall(policy)) {
    throw ConfigError(std::string(name) + ": it is no memory of this mission's robot " +
                      std::to_string(robot_.value));
  }
  root_->begin_run();
  begun_ = false;
  perception_.resume({});
  errand_->proceeded.reset();
}

}  // namespace tacit
