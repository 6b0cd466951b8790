#include "robot_agent/brain/forage_config.h"

#include "robot_agent/brain/forage_mind.h"

namespace tacit {
namespace {

void describe_avoidance(BrainConfig& config, ParameterVisitor& visitor) {
  describe(config.of<AvoidObstacles>(), visitor);
  auto& mates = config.of<AvoidSoldiers>();
  visitor.section("brain.avoid_soldiers", "AvoidSoldiers: a push away from each able teammate.");
  visitor.number("reach_m", mates.reach_m, {0.001, 1e6},
                 {"m", "Range at which a teammate starts to push [ours: as of an obstacle]."});
  visitor.number(
      "min_range_m", mates.min_range_m, {0.0, 1e6},
      {"m", "Range at which the linear push reaches 1 [ours: a little above two body radii]."});
  visitor.number("max_push", mates.max_push, {0.0, 20.0},
                 {"",
                  "The strongest push of one teammate [ours: MissionLab's infinity would keep two "
                  "robots from one base]."});
}

void describe_pursuit(QuarryTrack::Config& track, ParameterVisitor& visitor) {
  visitor.section("brain.pursue_enemy", "PursueEnemy: a unit pull to a meeting point.");
  visitor.integer("average_ticks", track.average_ticks, {1, 100},
                  {"ticks", "Window over which speeds are averaged for leading [MissionLab]."});
  visitor.number("gate_m", track.gate_m, {0.0, 100.0},
                 {"m",
                  "An enemy this near to where the pursued one was expected is taken for the same "
                  "[ours: three times a hunter's way in a tick]."});
}

void describe_actuator(Actuator::Config& actuator, ParameterVisitor& visitor) {
  visitor.section("brain.actuator", "How the weighted sum becomes a command.");
  visitor.number("base_mps", actuator.base_mps, {0.0, 100.0},
                 {"m/s", "Speed wanted for a sum of length 1 [MissionLab]."});
  visitor.number("max_mps", actuator.max_mps, {0.0, 100.0}, {"m/s", "Top speed [MissionLab]."});
  visitor.number("max_turn_radps", actuator.max_turn_radps, {0.0, 100.0},
                 {"rad/s", "Fastest turn wanted [ours: half a turn in a second]."});
  visitor.number("turn_gain_per_s", actuator.turn_gain_per_s, {0.0, 100.0},
                 {"1/s",
                  "Turn rate per radian between heading and motion [ours: half the way in a tick "
                  "of a second, so that it settles without overshoot]."});
  visitor.number("turn_from_mps", actuator.turn_from_mps, {0.0, 100.0},
                 {"m/s",
                  "Wanted speed below which the robot does not turn [ours: a robot at rest keeps "
                  "its heading]."});
}

}  // namespace

BrainConfig forage_defaults() {
  BrainConfig config;
  config.mission = MissionKind::Forage;
  config.learner = "q";
  config.of<AvoidObstacles>() = {.reach_m = 1.2, .margin_m = 0.3};
  config.of<AvoidSoldiers>() = {.reach_m = 1.2, .min_range_m = 0.5, .max_push = 1.0};
  config.actuator.base_mps = 0.2;
  config.actuator.max_mps = 0.5;
  config.actuator.turn_gain_per_s = 0.5;
  return config;
}

void describe_forage(BrainConfig& config, ParameterVisitor& visitor) {
  visitor.section("brain", "How each robot of the team decides.");
  visitor.choice("learner", config.learner, kForageLearners,
                 {"",
                  "What chooses the role: Q-learning (q), the same handcrafted rules in every "
                  "robot (homogeneous), or fixed roles (heterogeneous) [paper]."});
  describe(config.roles, visitor);
  describe_avoidance(config, visitor);
  describe(config.of<Noise>(), visitor);
  describe_pursuit(config.pursuit, visitor);
  describe_actuator(config.actuator, visitor);
  describe(config.heterogeneous, visitor);
  describe(config.q, visitor);
}

void check_forage(const BrainConfig& config) {
  check(config.roles);
  check(config.q);
  static_cast<void>(Heterogeneous(config.heterogeneous, RobotId{1}));
  static_cast<void>(ForageMind(config, Self{RobotId{1}, 0}));
}

}  // namespace tacit
