#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "idl/types/command.h"
#include "idl/types/event.h"
#include "idl/types/percept.h"
#include "idl/types/world_view.h"
#include "world_server/world/contact_log.h"
#include "world_server/world/digest.h"
#include "world_server/world/physics.h"
#include "world_server/world/sensing/senses.h"
#include "world_server/world/terrain.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// A body that comes and goes: an enemy of any kind.
struct Visitor {
  EnemyId id;
  EnemyKind kind = EnemyKind::Normal;
};

/// Nobody's index.
inline constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

/// Where every mission takes place: terrain, bodies and their contacts, senses, events and time.
///
/// Robot i of the lists is robot i+1 by its id. Visitors are numbered from 0 in the order in which
/// they entered; one that goes leaves the order of the others as it was.
class Stage {
 public:
  /// Throws ConfigError when the terrain or the robots cannot be placed.
  Stage(const WorldConfig& config, std::uint64_t seed);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  [[nodiscard]] const WorldConfig& config() const { return config_; }
  [[nodiscard]] const Terrain& terrain() const { return terrain_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] Tick tick() const { return tick_; }
  [[nodiscard]] const WorldVec& focus_m() const { return focus_m_; }

  [[nodiscard]] std::size_t robots() const { return robots_; }
  [[nodiscard]] RobotId id_of(std::size_t robot) const { return percepts_[robot].robot; }
  [[nodiscard]] const WorldVec& place_m(std::size_t robot) const { return places_m_[robot]; }
  [[nodiscard]] bool able(std::size_t robot) const { return percepts_[robot].able; }
  [[nodiscard]] bool holding(std::size_t robot) const { return percepts_[robot].holding; }
  /// What it does in this step beside moving; nothing when it was disabled or rested before.
  [[nodiscard]] Act act(std::size_t robot) const { return wanted_[robot].act; }
  /// What it wants in this step; nothing when it was disabled or rested before.
  [[nodiscard]] const Command& wanted(std::size_t robot) const { return wanted_[robot]; }
  [[nodiscard]] const Heading& heading(std::size_t robot) const { return headings_[robot]; }
  /// The nearest robot for which `fits(robot)` holds, at most `range_m` from `place_m`, the lowest
  /// id on a tie; `kNobody` when there is none.
  template <class Fits>
  [[nodiscard]] std::size_t nearest_robot(const WorldVec& place_m, double range_m, Fits fits) const;

  [[nodiscard]] std::span<const Visitor> visitors() const { return visitors_; }
  [[nodiscard]] const WorldVec& visitor_place_m(std::size_t k) const {
    return places_m_[robots_ + k];
  }

  /// Lets the place that the mission is about be seen, and how.
  void show_focus(const Look& look) { landmarks_ = {{focus_m_, look}}; }
  /// Lets these be seen and no other landmarks.
  void show_landmarks(std::span<const Landmark> landmarks) {
    landmarks_.assign(landmarks.begin(), landmarks.end());
  }
  /// Things that lie in the field and look like `look`; `where` is read at every look.
  void show_things(const BodyGrid& where, const Look& look) { things_ = {&where, look}; }

  void report(const Happening& what) { events_.push_back({tick_, what}); }
  /// To be filled in by the mission with what only it knows of, after the look.
  [[nodiscard]] Percept& percept(std::size_t robot) { return percepts_[robot]; }
  [[nodiscard]] Deeds& deeds(std::size_t robot) { return percepts_[robot].deeds; }
  void set_holding(std::size_t robot, bool holding) { percepts_[robot].holding = holding; }
  /// Stops the robot where it is until it is revived, and says so; nobody can push it along.
  void disable(std::size_t robot, Mishap by);
  void revive(std::size_t robot, RobotId by);
  /// How the robot looks from now on.
  void paint(std::size_t robot, const Look& look) { looks_[robot] = look; }
  /// From now on the robot does nothing, whatever it wants.
  void rest(std::size_t robot) { resting_[robot] = 1; }

  /// Brings a visitor in, and says so.
  void enter(const Visitor& visitor, const WorldVec& place_m, double radius_m);
  void drive_visitor(std::size_t k, const WorldVec& velocity_mps);
  /// Takes away the visitors k for which `gone[k]` is not 0.
  void dismiss(std::span<const std::uint8_t> gone);

  /// The steps of a tick, in order.
  void begin();
  void drive_robots(std::span<const Command> commands);
  void move();
  void count_tick() { ++tick_; }
  void look();

  [[nodiscard]] std::span<const Percept> percepts() const { return percepts_; }
  [[nodiscard]] std::span<const Event> events() const { return events_; }
  [[nodiscard]] Checkpoint checkpoint(std::uint64_t state_digest) const;
  void add_to(Digest& digest) const;
  void show(WorldView& out) const;

 private:
  void place_robots();
  void add_body(const WorldVec& place_m, const Look& look);
  void turn(std::size_t robot, double turn_radps);
  void keep_visitor(std::size_t from, std::size_t to);
  void report_contacts();
  [[nodiscard]] std::size_t index_of(BodySlot slot) const;
  [[nodiscard]] Collision collision(const Contact& contact) const;
  [[nodiscard]] OdometryPose odometry(std::size_t robot) const;

  WorldConfig config_;
  std::uint64_t seed_;
  Terrain terrain_;
  Physics physics_;
  BodyGrid grid_;
  Senses senses_;
  ContactLog contact_log_;
  WorldVec focus_m_;
  std::vector<Landmark> landmarks_;
  Things things_;
  std::size_t robots_;
  Tick tick_ = 0;
  std::vector<WorldPose> starts_;
  std::vector<Visitor> visitors_;
  // Bodies are held as parallel lists, robots first: visitor k stands at index robots_ + k.
  std::vector<BodySlot> slots_;
  std::vector<WorldVec> places_m_;
  std::vector<WorldVec> velocities_mps_;
  std::vector<Look> looks_;
  std::vector<Heading> headings_;      ///< Robots only.
  std::vector<std::uint8_t> resting_;  ///< Robots only.
  std::vector<Percept> percepts_;
  std::vector<Command> wanted_;
  std::vector<Contact> robot_contacts_;
  std::vector<Event> events_;
};

template <class Fits>
std::size_t Stage::nearest_robot(const WorldVec& place_m, double range_m, Fits fits) const {
  std::size_t nearest = kNobody;
  double nearest2 = range_m * range_m;
  grid_.near(place_m, range_m, [&](std::size_t body, const WorldVec& at) {
    if (body >= robots_ || !fits(body)) {
      return;
    }
    const double range2 = (at - place_m).squared_norm();
    if (range2 < nearest2 || (range2 == nearest2 && body < nearest)) {
      nearest = body;
      nearest2 = range2;
    }
  });
  return nearest;
}

}  // namespace tacit
