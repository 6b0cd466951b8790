#include "robot_agent/brain/brain_config.h"

#include <algorithm>

#include "idl/types/config_error.h"
#include "idl/types/shortest.h"
#include "robot_agent/brain/forage_config.h"
#include "robot_agent/brain/operation_config.h"

namespace tacit {
namespace {

/// Throws at the first value outside its range.
class RangeCheck final : public ParameterVisitor {
 public:
  void section(std::string_view name, std::string_view /*doc*/) override { section_ = name; }

  void number(std::string_view key, double& value, Range range, ParameterDoc doc) override {
    // Written so that a NaN fails.
    if (value >= range.min && value <= range.max) return;
    const std::string unit = doc.unit.empty() ? std::string() : std::string(" ").append(doc.unit);
    fail(key, shortest(value) + unit, shortest(range.min) + " to " + shortest(range.max) + unit);
  }

  void integer(std::string_view key, std::int64_t& value, Range range, ParameterDoc doc) override {
    auto as_number = static_cast<double>(value);
    number(key, as_number, range, doc);
  }

  void flag(std::string_view /*key*/, bool& /*value*/, ParameterDoc /*doc*/) override {}

  void choice(std::string_view key, std::string& value, std::span<const std::string_view> choices,
              ParameterDoc /*doc*/) override {
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
    std::string wanted = "one of";
    for (const std::string_view each : choices) wanted.append(" ").append(each);
    fail(key, value, wanted);
  }

  void rows(std::string_view key, std::vector<std::vector<double>>& value,
            std::span<const std::string_view> /*columns*/, Range range, ParameterDoc doc) override {
    for (std::vector<double>& row : value) {
      for (double& each : row) number(key, each, range, doc);
    }
  }

  void text(std::string_view /*key*/, std::string& /*value*/, ParameterDoc /*doc*/) override {}

  void texts(std::string_view /*key*/, std::vector<std::string>& /*value*/,
             ParameterDoc /*doc*/) override {}

 private:
  [[noreturn]] void fail(std::string_view key, const std::string& found,
                         const std::string& wanted) const {
    throw ConfigError(section_ + "." + std::string(key) + " is " + found + ", wanted " + wanted);
  }

  std::string section_;
};

struct GainsSection {
  std::string_view name;
  std::string_view doc;
  std::string_view value_doc;
};

void describe_gains(Gains& gains, const GainsSection& section, ParameterVisitor& visitor) {
  visitor.section(section.name, section.doc);
  for_each_schema([&]<class S>() {
    visitor.number(S::kKey, gains.of<S>(), {0.0, 1000.0}, {"", section.value_doc});
  });
}

Gains guard_gains(double move_to_target, double intercept) {
  Gains gains;
  gains.of<MoveToTarget>() = move_to_target;
  gains.of<InterceptEnemies>() = intercept;
  gains.of<AvoidSoldiers>() = 0.3;
  gains.of<AvoidObstacles>() = 1.0;
  return gains;
}

void describe_guard(BrainConfig& config, ParameterVisitor& visitor) {
  visitor.section("brain", "How each robot of the team decides.");
  visitor.choice("learner", config.learner, kGuardLearners,
                 {"",
                  "What sets the gains: fixed weights (static1, static2), learning momentum (lm), "
                  "or wandering to a goal without a thought of enemies (crowd) [paper]."});
  describe(config.enemy_groups, visitor);
  describe(config.occlusion, visitor);
  describe(config.situation, visitor);
  for_each_schema([&]<class S>() { describe(config.of<S>(), visitor); });
  describe(config.actuator, visitor);
  describe_gains(config.static1,
                 {"brain.static1", "Gains of Static1 soldiers.",
                  "Weight of this schema [ours: the paper only says that Static1 and Static2 "
                  "differ in MoveToTarget alone, Static1's being lower]."},
                 visitor);
  describe_gains(config.static2,
                 {"brain.static2", "Gains of Static2 soldiers.",
                  "Weight of this schema [ours: as Static1's, with a MoveToTarget that holds the "
                  "team together when nothing happens]."},
                 visitor);
  describe_gains(config.crowd,
                 {"brain.crowd", "Gains of robots in a crowd.",
                  "Weight of this schema [ours: avoidance as strong as the goal, chance weaker]."},
                 visitor);
  describe(config.lm, visitor);
}

void check_guard(const BrainConfig& config) {
  for_each_schema([&]<class S>() {
    static_cast<void>(make_schema<S>(config.schemas, Self{RobotId{1}, 0}));
  });
  static_cast<void>(LearningMomentum(config.lm, config.situation, Occlusion(config.occlusion)));
}

}  // namespace

Gains static1_gains() { return guard_gains(0.4, 1.0); }

Gains static2_gains() { return guard_gains(1.0, 1.0); }

Gains crowd_gains() {
  Gains gains;
  gains.of<MoveToTarget>() = 1.0;
  gains.of<AvoidSoldiers>() = 1.0;
  gains.of<AvoidObstacles>() = 1.0;
  gains.of<Noise>() = 0.3;
  return gains;
}

LearningMomentum::Config learning_momentum_config() {
  LearningMomentum::Config config;
  config.initial = guard_gains(1.0, 0.5);
  return config;
}

BrainConfig brain_defaults(MissionKind mission) {
  switch (mission) {
    case MissionKind::Guard:
      return {};
    case MissionKind::Forage:
      return forage_defaults();
    case MissionKind::Operation:
      return operation_defaults();
  }
  return {};
}

void describe(BrainConfig& config, ParameterVisitor& visitor) {
  switch (config.mission) {
    case MissionKind::Guard:
      return describe_guard(config, visitor);
    case MissionKind::Forage:
      return describe_forage(config, visitor);
    case MissionKind::Operation:
      return describe_operation(config, visitor);
  }
}

void check(const BrainConfig& config) {
  BrainConfig copy = config;
  RangeCheck ranges;
  describe(copy, ranges);
  switch (config.mission) {
    case MissionKind::Guard:
      return check_guard(config);
    case MissionKind::Forage:
      return check_forage(config);
    case MissionKind::Operation:
      return check_operation(config);
  }
}

}  // namespace tacit
