#include "world_server/world/world.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <vector>

#include "idl/types/config_error.h"
#include "world_server/world/contact_log.h"
#include "world_server/world/digest.h"
#include "world_server/world/enemies/enemy_mind.h"
#include "world_server/world/enemies/spawner.h"
#include "world_server/world/physics.h"
#include "world_server/world/sensing/senses.h"
#include "world_server/world/start.h"
#include "world_server/world/terrain.h"

namespace tacit {
namespace {

WorldConfig checked(const WorldConfig& config) {
  check(config);
  return config;
}

constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

}  // namespace

// Bodies are held as parallel lists, robots first: index i is robot i+1, and enemy k stands at
// index robots + k. An enemy that goes leaves the order of the others as it was.
class World::Impl {
 public:
  Impl(const WorldConfig& config, std::uint64_t seed)
      : config_(checked(config)),
        terrain_(make_terrain(config_, seed)),
        physics_(terrain_),
        grid_(terrain_.width_m, terrain_.height_m, config_.sight.range_m),
        senses_(config_, terrain_, seed),
        spawner_(config_, terrain_, seed),
        mind_(config_, terrain_),
        seed_(seed),
        robots_(static_cast<std::size_t>(config_.robots.count)),
        target_m_(config_.target.x_m, config_.target.y_m) {
    place_robots();
    alive_.assign(spawner_.waves(), 0);
    look();
  }

  std::span<const Event> step(std::span<const Command> commands) {
    events_.clear();
    spawn_enemies();
    drive_robots(commands);
    drive_enemies();
    move();
    report_contacts();
    settle_enemies();
    ++tick_;
    if (tick_ % static_cast<Tick>(config_.physics.checkpoint_ticks) == 0) {
      events_.push_back({tick_, checkpoint()});
    }
    look();
    return events_;
  }

  [[nodiscard]] Tick tick() const { return tick_; }
  [[nodiscard]] std::span<const Percept> percepts() const { return percepts_; }

  [[nodiscard]] std::uint64_t digest() const {
    Digest digest;
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
    return digest.value();
  }

  void view(WorldView& out) const {
    out.tick = tick_;
    out.time_s = static_cast<double>(tick_) * config_.physics.tick_s;
    out.robots.clear();
    out.enemies.clear();
    for (std::size_t i = 0; i < robots_; ++i) {
      out.robots.push_back(
          {percepts_[i].robot, {places_m_[i], headings_[i]}, velocities_mps_[i], true});
    }
    for (std::size_t k = 0; k < enemies_.size(); ++k) {
      out.enemies.push_back({enemies_[k].id, enemies_[k].kind, places_m_[robots_ + k]});
    }
  }

 private:
  void place_robots() {
    starts_ = start_poses(config_, terrain_, seed_);
    for (const WorldPose& pose : starts_) {
      slots_.push_back(physics_.add(pose.position_m, config_.robots.radius_m));
      places_m_.push_back(pose.position_m);
      velocities_mps_.emplace_back();
      headings_.push_back(pose.heading);
    }
    percepts_.resize(robots_);
    for (std::size_t i = 0; i < robots_; ++i) {
      percepts_[i].robot = RobotId{static_cast<std::uint16_t>(i + 1)};
    }
  }

  void spawn_enemies() {
    for (const Arrival& arrival : spawner_.arrivals(tick_, alive_)) {
      const EnemyId id{++created_};
      enemies_.push_back({id,
                          arrival.kind,
                          arrival.wave,
                          arrival.position_m,
                          Stream(seed_, "enemy heading", id.value),
                          {},
                          0});
      slots_.push_back(physics_.add(arrival.position_m, config_.enemies.radius_m));
      places_m_.push_back(arrival.position_m);
      velocities_mps_.emplace_back();
      ++alive_[arrival.wave];
      events_.push_back({tick_, EnemyCreated{id, arrival.kind, arrival.position_m}});
    }
  }

  void drive_robots(std::span<const Command> commands) {
    wanted_.assign(robots_, Command{});
    for (const Command& command : commands) {
      assert(command.robot.value >= 1 && command.robot.value <= robots_);
      wanted_[command.robot.value - 1u] = command;
    }
    const double most_change_mps = config_.robots.max_acceleration_mps2 * config_.physics.tick_s;
    for (std::size_t i = 0; i < robots_; ++i) {
      const BodyVec wanted = clipped(wanted_[i].velocity_mps, config_.robots.max_speed_mps);
      const WorldVec change = from_body<WorldFrame>(headings_[i], wanted) - velocities_mps_[i];
      physics_.set_velocity(slots_[i], velocities_mps_[i] + clipped(change, most_change_mps));
      turn(i, wanted_[i].turn_radps);
    }
  }

  void turn(std::size_t robot, double turn_radps) {
    const double most = config_.robots.max_turn_radps;
    const double angle_rad = std::clamp(turn_radps, -most, most) * config_.physics.tick_s;
    if (angle_rad != 0.0) {
      headings_[robot] = headings_[robot].turned(angle_rad);
    }
  }

  void drive_enemies() {
    for (std::size_t k = 0; k < enemies_.size(); ++k) {
      const std::size_t i = robots_ + k;
      physics_.set_velocity(slots_[i], mind_.velocity(enemies_[k], places_m_[i], tick_));
    }
  }

  void move() {
    physics_.step(config_.physics.tick_s, config_.physics.substeps);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      places_m_[i] = physics_.position(slots_[i]);
      velocities_mps_[i] = physics_.velocity(slots_[i]);
    }
  }

  // Slots and indices part company once an enemy has gone.
  [[nodiscard]] std::size_t index_of(BodySlot slot) const {
    if (slot < robots_) {
      return slot;
    }
    const auto first = slots_.begin() + static_cast<std::ptrdiff_t>(robots_);
    return static_cast<std::size_t>(std::find(first, slots_.end(), slot) - slots_.begin());
  }

  void report_contacts() {
    for (Percept& percept : percepts_) {
      percept.touching = false;
    }
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
      events_.push_back({tick_, collision(contact)});
    }
  }

  [[nodiscard]] Collision collision(const Contact& contact) const {
    const RobotId robot{static_cast<std::uint16_t>(contact.mover + 1)};
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
               : Collision{robot, Obstruction::Enemy, enemies_[other - robots_].id.value};
  }

  // A robot that reaches an enemy destroys it, also when the enemy reaches the target in the same
  // tick: "a soldier is always able to kill an enemy when intercepted" (paper, section 2).
  void settle_enemies() {
    grid_.rebuild(places_m_);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < enemies_.size(); ++k) {
      const std::optional<Happening> end = ending(k);
      if (end) {
        events_.push_back({tick_, *end});
        --alive_[enemies_[k].wave];
        physics_.remove(slots_[robots_ + k]);
      } else {
        keep_enemy(k, kept++);
      }
    }
    if (kept != enemies_.size()) {
      enemies_.erase(enemies_.begin() + static_cast<std::ptrdiff_t>(kept), enemies_.end());
      slots_.resize(robots_ + kept);
      places_m_.resize(robots_ + kept);
      velocities_mps_.resize(robots_ + kept);
      grid_.rebuild(places_m_);
    }
  }

  void keep_enemy(std::size_t from, std::size_t to) {
    if (from != to) {
      enemies_[to] = enemies_[from];
      slots_[robots_ + to] = slots_[robots_ + from];
      places_m_[robots_ + to] = places_m_[robots_ + from];
      velocities_mps_[robots_ + to] = velocities_mps_[robots_ + from];
    }
  }

  [[nodiscard]] std::optional<Happening> ending(std::size_t k) const {
    const WorldVec& place = enemy_place(k);
    const double to_target_m = (place - target_m_).norm();
    const std::size_t killer = interceptor(place);
    if (killer != kNobody) {
      return EnemyIntercepted{enemies_[k].id, enemies_[k].kind, percepts_[killer].robot,
                              to_target_m};
    }
    if (to_target_m <= config_.enemies.hit_radius_m) {
      return TargetHit{enemies_[k].id, to_target_m};
    }
    return std::nullopt;
  }

  // While survivors are moved to the front, place k still holds enemy k until k is decided.
  [[nodiscard]] const WorldVec& enemy_place(std::size_t k) const { return places_m_[robots_ + k]; }

  [[nodiscard]] std::size_t interceptor(const WorldVec& place) const {
    std::size_t nearest = kNobody;
    double nearest2 = config_.enemies.kill_radius_m * config_.enemies.kill_radius_m;
    grid_.near(place, config_.enemies.kill_radius_m, [&](std::size_t body, const WorldVec& at) {
      if (body >= robots_) {
        return;
      }
      const double range2 = (at - place).squared_norm();
      if (range2 < nearest2 || (range2 == nearest2 && body < nearest)) {
        nearest = body;
        nearest2 = range2;
      }
    });
    return nearest;
  }

  [[nodiscard]] Checkpoint checkpoint() const {
    double distance = 0.0;
    double speed = 0.0;
    for (std::size_t i = 0; i < robots_; ++i) {
      distance += (places_m_[i] - target_m_).norm();
      speed += velocities_mps_[i].norm();
    }
    const auto count = static_cast<double>(robots_);
    return {digest(), static_cast<std::uint32_t>(enemies_.size()), distance / count, speed / count};
  }

  void look() {
    if (tick_ == 0) {
      grid_.rebuild(places_m_);
    }
    const Scene scene{places_m_, headings_, &grid_};
    for (std::size_t i = 0; i < robots_; ++i) {
      Percept& percept = percepts_[i];
      percept.tick = tick_;
      percept.velocity_mps = to_body(headings_[i], velocities_mps_[i]);
      percept.odometry = odometry(i);
      senses_.sense(scene, i, percept);
    }
  }

  [[nodiscard]] OdometryPose odometry(std::size_t robot) const {
    const WorldPose& start = starts_[robot];
    const BodyVec moved = to_body(start.heading, places_m_[robot] - start.position_m);
    const Heading& h = headings_[robot];
    const Heading& h0 = start.heading;
    return {OdometryVec{moved.xy},
            {h.cos * h0.cos + h.sin * h0.sin, h.sin * h0.cos - h.cos * h0.sin}};
  }

  WorldConfig config_;
  Terrain terrain_;
  Physics physics_;
  BodyGrid grid_;
  Senses senses_;
  Spawner spawner_;
  EnemyMind mind_;
  ContactLog contact_log_;
  std::uint64_t seed_;
  std::size_t robots_;
  WorldVec target_m_;
  Tick tick_ = 0;
  std::uint32_t created_ = 0;
  std::vector<WorldPose> starts_;
  std::vector<Enemy> enemies_;
  std::vector<std::int64_t> alive_;  ///< Enemies alive, per wave.
  std::vector<BodySlot> slots_;
  std::vector<WorldVec> places_m_;
  std::vector<WorldVec> velocities_mps_;
  std::vector<Heading> headings_;  ///< Robots only.
  std::vector<Percept> percepts_;
  std::vector<Command> wanted_;
  std::vector<Contact> robot_contacts_;
  std::vector<Event> events_;
};

World::World(const WorldConfig& config, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(config, seed)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

Tick World::tick() const { return impl_->tick(); }
std::span<const Percept> World::percepts() const { return impl_->percepts(); }
std::span<const Event> World::step(std::span<const Command> commands) {
  return impl_->step(commands);
}
std::uint64_t World::digest() const { return impl_->digest(); }
void World::view(WorldView& out) const { impl_->view(out); }

}  // namespace tacit
