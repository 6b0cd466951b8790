#include "robot_agent/brain/schemas/intercept_enemies.h"

#include "robot_agent/brain/perception/enemy_groups.h"

namespace tacit {

BodyVec InterceptEnemies::push(const Surroundings& around) {
  const EnemyGroup* group = around.open_group;
  if (group == nullptr) group = nearest_group(around.groups);
  if (group == nullptr || group->nearest.range_m == 0.0) return {};

  const Seen& quarry = group->nearest;
  const OdometryPose& own = around.odometry;
  track_.note(around.tick, own.position_m + from_body<OdometryFrame>(own.heading, quarry.offset_m),
              own.position_m);
  BodyVec straight = (1.0 / quarry.range_m) * quarry.offset_m;
  const auto motion = track_.motion();
  if (!motion) return straight;
  return lead(straight, to_body(own.heading, motion->quarry_m_per_tick),
              motion->self_m_per_tick.norm())
      .value_or(straight);
}

std::optional<BodyVec> lead(const BodyVec& towards, const BodyVec& quarry_velocity, double speed) {
  // The bearing stays constant, and the two meet, when both move equally fast across the line of
  // sight. That is the law of sines of the triangle robot, quarry, meeting point.
  const double across = towards.cross(quarry_velocity);
  if (across * across > speed * speed || speed <= 0.0) return std::nullopt;
  const double sine = across / speed;
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double closing = speed * cosine - towards.dot(quarry_velocity);
  if (closing <= 0.0) return std::nullopt;
  return BodyVec{cosine * towards.x() - sine * towards.y(),
                 cosine * towards.y() + sine * towards.x()};
}

void describe(InterceptEnemies::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.intercept_enemies", "InterceptEnemies: a unit pull to a meeting point.");
  describe(config.track, visitor);
}

}  // namespace tacit
