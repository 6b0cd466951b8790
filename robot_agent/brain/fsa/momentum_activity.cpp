#include "robot_agent/brain/fsa/momentum_activity.h"

#include <algorithm>

namespace tacit {
namespace {

RobotMomentum::Gains initial(const MomentumPlan& plan) {
  return {plan.goal.gain, plan.obstacle_gain, plan.noise_gain, plan.obstacle_sphere_m, 10};
}

}  // namespace

MomentumActivity::MomentumActivity(const MomentumPlan& plan, const Self& self)
    : plan_(plan),
      self_(self),
      momentum_(initial(plan), Stream(self.seed, "learning momentum", self.robot.value)),
      goal_(make_schema(plan.goal, SchemaConfigs{}, self)) {
  // Checks that the margin lies within the sphere before momentum squeezes the sphere.
  static_cast<void>(AvoidObstacles({plan.obstacle_sphere_m, plan.obstacle_margin_m}));
  apply();
}

// A sphere that was squeezed below the margin pushes with the margin's force alone.
void MomentumActivity::apply() {
  const RobotMomentum::Gains& gains = momentum_.gains();
  const double margin_m = std::min(plan_.obstacle_margin_m, 0.999 * gains.sphere_m);
  obstacles_.emplace(AvoidObstacles::Config{gains.sphere_m, margin_m});
  robots_.emplace(AvoidRobots::Config{gains.sphere_m, margin_m, true, true});
  noise_.emplace(Noise::Config{gains.persistence}, self_);
}

void MomentumActivity::enter(const Entry& /*entry*/) {
  goal_->enter();
  last_m_.reset();
  shares_.clear();
}

Doing MomentumActivity::step(const Surroundings& around) {
  const OdometryVec& place_m = around.odometry.position_m;
  if (last_m_) {
    const RobotMomentum::Sample sample{(place_m - *last_m_).norm(), to_goal_m(around),
                                       pushing_obstacles(around)};
    if (momentum_.note(sample)) apply();
  }
  last_m_ = place_m;
  const RobotMomentum::Gains& gains = momentum_.gains();
  shares_ = {{name(plan_.goal), gains.goal, goal_->push(around)},
             {std::string(AvoidObstacles::kName), gains.obstacle, obstacles_->push(around)},
             {std::string(AvoidRobots::kName), gains.obstacle, robots_->push(around)},
             {std::string(Noise::kName), gains.noise, noise_->push(around)},
             {std::string(Telop::kName), 1.0, telop_.push(around)}};
  Doing doing;
  for (const SchemaShare& share : shares_) doing.add(share.gain, share.push);
  return doing;
}

double MomentumActivity::to_goal_m(const Surroundings& around) const {
  if (const auto* place = std::get_if<MoveToPlace::Config>(&plan_.goal.setting)) {
    return (place->goal_m - around.premises.pose.position_m).norm();
  }
  const Nearest& goal = around.nearest_of(plan_.goal.things);
  return goal.known() ? std::sqrt(goal.squared_range_m2) : 0.0;
}

double MomentumActivity::pushing_obstacles(const Surroundings& around) const {
  const double sphere_m = momentum_.gains().sphere_m;
  const auto pushes = [sphere_m](const SeenObstacle& each) {
    return each.offset_m.norm() - each.radius_m < sphere_m;
  };
  return static_cast<double>(
      std::count_if(around.obstacles.begin(), around.obstacles.end(), pushes));
}

void MomentumActivity::report(std::vector<SchemaShare>& shares) const { shares = shares_; }

void MomentumActivity::note(Record& record) const {
  const RobotMomentum::Gains& gains = momentum_.gains();
  record.add(gains.goal);
  record.add(gains.obstacle);
  record.add(gains.noise);
  record.add(gains.sphere_m);
  record.add_count(static_cast<std::uint64_t>(gains.persistence));
  record.add_count(momentum_.chance_position());
}

bool MomentumActivity::resume(RecordReader& record) {
  RobotMomentum::Gains gains;
  gains.goal = record.number();
  gains.obstacle = record.number();
  gains.noise = record.number();
  gains.sphere_m = record.number();
  gains.persistence = static_cast<std::int64_t>(record.count(16));
  const std::uint64_t position = record.count(RecordReader::kMostTicks);
  if (!record.sound() || gains.persistence < 1 || !(gains.sphere_m > 0.0)) return false;
  momentum_.resume(gains, position);
  apply();
  return true;
}

}  // namespace tacit
