#include "world_server/world/stage.h"

#include <algorithm>
#include <cassert>

#include "world_server/world/start.h"

namespace tacit {
namespace {

WorldVec focus_of(const WorldConfig& config) {
  const FocusPoint point = focus(config);
  return {point.x_m, point.y_m};
}

// In what order Bullet resolves contacts depends on all that it was ever given, and the guard's
// histories are pinned with all bodies in it.
Physics::Care care_of(const WorldConfig& config) {
  return config.mission == MissionKind::Guard ? Physics::Care::All : Physics::Care::Near;
}

}  // namespace

Stage::Stage(const WorldConfig& config, std::uint64_t seed)
    : config_(config),
      seed_(seed),
      terrain_(make_terrain(config_, seed)),
      physics_(terrain_, care_of(config_)),
      grid_(terrain_.width_m, terrain_.height_m, config_.sight.range_m),
      senses_(config_, terrain_, seed),
      focus_m_(focus_of(config_)),
      robots_(static_cast<std::size_t>(config_.robots.count)) {
  place_robots();
  grid_.rebuild(places_m_);
}

void Stage::place_robots() {
  starts_ = start_poses(config_, terrain_, seed_);
  for (const WorldPose& pose : starts_) {
    add_body(pose.position_m, {Kind::Teammate, Colour::Blue, config_.robots.radius_m});
    headings_.push_back(pose.heading);
  }
  percepts_.resize(robots_);
  resting_.assign(robots_, 0);
  for (std::size_t i = 0; i < robots_; ++i) {
    percepts_[i].robot = RobotId{static_cast<std::uint16_t>(i + 1)};
  }
}

void Stage::add_body(const WorldVec& place_m, const Look& look) {
  slots_.push_back(physics_.add(place_m, look.radius_m));
  places_m_.push_back(place_m);
  velocities_mps_.emplace_back();
  looks_.push_back(look);
}

void Stage::disable(std::size_t robot, Mishap by) {
  percepts_[robot].able = false;
  looks_[robot].colour = Colour::Yellow;
  velocities_mps_[robot] = {};
  physics_.pin(slots_[robot]);
  report(RobotDisabled{id_of(robot), by});
}

void Stage::revive(std::size_t robot, RobotId by) {
  percepts_[robot].able = true;
  looks_[robot].colour = Colour::Blue;
  physics_.unpin(slots_[robot]);
  report(RobotRevived{id_of(robot), by});
}

void Stage::enter(const Visitor& visitor, const WorldVec& place_m, double radius_m) {
  visitors_.push_back(visitor);
  add_body(place_m, {Kind::Enemy, Colour::Red, radius_m});
  report(EnemyCreated{visitor.id, visitor.kind, place_m});
}

void Stage::drive_visitor(std::size_t k, const WorldVec& velocity_mps) {
  physics_.set_velocity(slots_[robots_ + k], velocity_mps);
}

void Stage::dismiss(std::span<const std::uint8_t> gone) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < visitors_.size(); ++k) {
    if (gone[k] != 0) {
      physics_.remove(slots_[robots_ + k]);
    } else {
      keep_visitor(k, kept++);
    }
  }
  if (kept != visitors_.size()) {
    visitors_.resize(kept);
    slots_.resize(robots_ + kept);
    places_m_.resize(robots_ + kept);
    velocities_mps_.resize(robots_ + kept);
    looks_.resize(robots_ + kept);
    grid_.rebuild(places_m_);
  }
}

void Stage::keep_visitor(std::size_t from, std::size_t to) {
  if (from != to) {
    visitors_[to] = visitors_[from];
    slots_[robots_ + to] = slots_[robots_ + from];
    places_m_[robots_ + to] = places_m_[robots_ + from];
    velocities_mps_[robots_ + to] = velocities_mps_[robots_ + from];
    looks_[robots_ + to] = looks_[robots_ + from];
  }
}

void Stage::begin() {
  events_.clear();
  for (Percept& percept : percepts_) {
    percept.touching = false;
    percept.deeds = {};
  }
}

void Stage::drive_robots(std::span<const Command> commands) {
  wanted_.assign(robots_, Command{});
  for (const Command& command : commands) {
    assert(command.robot.value >= 1 && command.robot.value <= robots_);
    const std::size_t robot = command.robot.value - 1u;
    if (able(robot) && resting_[robot] == 0) {
      wanted_[robot] = command;
    }
  }
  const double most_change_mps = config_.robots.max_acceleration_mps2 * config_.physics.tick_s;
  for (std::size_t i = 0; i < robots_; ++i) {
    const BodyVec wanted = clipped(wanted_[i].velocity_mps, config_.robots.max_speed_mps);
    const WorldVec change = from_body<WorldFrame>(headings_[i], wanted) - velocities_mps_[i];
    physics_.set_velocity(slots_[i], velocities_mps_[i] + clipped(change, most_change_mps));
    turn(i, wanted_[i].turn_radps);
  }
}

void Stage::turn(std::size_t robot, double turn_radps) {
  const double most = config_.robots.max_turn_radps;
  const double angle_rad = std::clamp(turn_radps, -most, most) * config_.physics.tick_s;
  if (angle_rad != 0.0) {
    headings_[robot] = headings_[robot].turned(angle_rad);
  }
}

void Stage::move() {
  physics_.step(config_.physics.tick_s, config_.physics.substeps);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    places_m_[i] = physics_.position(slots_[i]);
    velocities_mps_[i] = physics_.velocity(slots_[i]);
  }
  report_contacts();
  grid_.rebuild(places_m_);
}

// Slots and indices part company once a visitor has gone.
std::size_t Stage::index_of(BodySlot slot) const {
  if (slot < robots_) {
    return slot;
  }
  const auto first = slots_.begin() + static_cast<std::ptrdiff_t>(robots_);
  return static_cast<std::size_t>(std::find(first, slots_.end(), slot) - slots_.begin());
}

void Stage::report_contacts() {
  robot_contacts_.clear();
  for (const Contact& contact : physics_.contacts()) {
    if (contact.mover < robots_) {
      robot_contacts_.push_back(contact);
      percepts_[contact.mover].touching = true;
      if (contact.with == ContactSide::Mover && contact.other < robots_) {
        percepts_[contact.other].touching = true;
      }
    }
  }
  for (const Contact& contact : contact_log_.begun(robot_contacts_, tick_)) {
    report(collision(contact));
  }
}

Collision Stage::collision(const Contact& contact) const {
  const RobotId robot = id_of(contact.mover);
  switch (contact.with) {
    case ContactSide::Obstacle:
      return {robot, Obstruction::Obstacle, contact.other};
    case ContactSide::Wall:
      return {robot, Obstruction::Wall, contact.other};
    case ContactSide::Mover:
      break;
  }
  const std::size_t other = index_of(contact.other);
  return other < robots_
             ? Collision{robot, Obstruction::Robot, static_cast<std::uint32_t>(other + 1)}
             : Collision{robot, Obstruction::Enemy, visitors_[other - robots_].id.value};
}

void Stage::look() {
  const Scene scene{places_m_, headings_, looks_, &grid_, landmarks_, things_};
  for (std::size_t i = 0; i < robots_; ++i) {
    Percept& percept = percepts_[i];
    percept.tick = tick_;
    percept.velocity_mps = to_body(headings_[i], velocities_mps_[i]);
    percept.odometry = odometry(i);
    senses_.sense(scene, i, percept);
  }
}

OdometryPose Stage::odometry(std::size_t robot) const {
  const WorldPose& start = starts_[robot];
  const BodyVec moved = to_body(start.heading, places_m_[robot] - start.position_m);
  const Heading& h = headings_[robot];
  const Heading& h0 = start.heading;
  return {OdometryVec{moved.xy},
          {h.cos * h0.cos + h.sin * h0.sin, h.sin * h0.cos - h.cos * h0.sin}};
}

Checkpoint Stage::checkpoint(std::uint64_t state_digest) const {
  double distance = 0.0;
  double speed = 0.0;
  for (std::size_t i = 0; i < robots_; ++i) {
    distance += (places_m_[i] - focus_m()).norm();
    speed += velocities_mps_[i].norm();
  }
  const auto count = static_cast<double>(robots_);
  return {state_digest, static_cast<std::uint32_t>(visitors_.size()), distance / count,
          speed / count};
}

void Stage::add_to(Digest& digest) const {
  digest.add(tick_);
  for (std::size_t i = 0; i < places_m_.size(); ++i) {
    digest.add(places_m_[i].x());
    digest.add(places_m_[i].y());
    digest.add(velocities_mps_[i].x());
    digest.add(velocities_mps_[i].y());
  }
  for (const Heading& heading : headings_) {
    digest.add(heading.cos);
    digest.add(heading.sin);
  }
}

void Stage::show(WorldView& out) const {
  out.tick = tick_;
  out.time_s = static_cast<double>(tick_) * config_.physics.tick_s;
  out.robots.clear();
  out.enemies.clear();
  out.mines.clear();
  out.objects.clear();
  for (std::size_t i = 0; i < robots_; ++i) {
    out.robots.push_back({id_of(i),
                          {places_m_[i], headings_[i]},
                          velocities_mps_[i],
                          true,
                          able(i),
                          holding(i),
                          looks_[i].colour});
  }
  for (std::size_t k = 0; k < visitors_.size(); ++k) {
    out.enemies.push_back({visitors_[k].id, visitors_[k].kind, visitor_place_m(k)});
  }
}

}  // namespace tacit
