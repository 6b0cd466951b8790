#include "world_server/world/world_config.h"

#include <array>
#include <string_view>

#include "world_server/world/refuse.h"

namespace tacit {
namespace {

constexpr std::array<std::string_view, 4> kWallColumns{"x1", "y1", "x2", "y2"};
constexpr std::array<std::string_view, 3> kDiscColumns{"x", "y", "r"};
constexpr std::array<std::string_view, 3> kStarts{"ring", "scattered", "gathered"};
constexpr std::array<std::string_view, 2> kDoors{"open", "closed"};

void describe_area(AreaConfig& area, ParameterVisitor& v) {
  v.section("area", "The rectangle in which everything happens.");
  v.text("map", area.map,
         {"",
          "MissionLab overlay (.ovl) from which area, walls, obstacles and start place come; empty "
          "for none. [MissionLab]"});
  v.choice("doors", area.doors, kDoors, {"", "How the doors of a map stand. [ours]"});
  v.number("width_m", area.width_m, {1, 100000}, {"m", "West to east. [paper]"});
  v.number("height_m", area.height_m, {1, 100000}, {"m", "South to north. [paper]"});
  v.flag("border_walls", area.border_walls,
         {"", "Whether walls close the area. [ours: MissionLab clamps positions instead]"});
  v.rows("walls", area.walls, kWallColumns, {-1e5, 1e5},
         {"m", "Straight walls inside the area, from (x1, y1) to (x2, y2). [ours]"});
}

void describe_target(TargetConfig& target, ParameterVisitor& v) {
  v.section("target", "The object that the team guards; it cannot be destroyed.");
  v.number("x_m", target.x_m, {0, 100000}, {"m", "Position from the west border. [paper]"});
  v.number("y_m", target.y_m, {0, 100000}, {"m", "Position from the south border. [paper]"});
  v.number("radius_m", target.radius_m, {0, 100}, {"m", "Apparent radius. [ours]"});
}

void describe_obstacles(ObstacleConfig& obstacles, ParameterVisitor& v) {
  v.section("obstacles", "Round static obstacles, placed by chance.");
  v.number("coverage_percent", obstacles.coverage_percent, {0, 60},
           {"%", "Share of the area that obstacles cover. [paper]"});
  v.number("min_radius_m", obstacles.min_radius_m, {0.01, 1000}, {"m", "Smallest. [paper]"});
  v.number("max_radius_m", obstacles.max_radius_m, {0.01, 1000}, {"m", "Largest. [paper]"});
  v.number("keep_free_m", obstacles.keep_free_m, {0, 100000},
           {"m",
            "No obstacle placed by chance reaches nearer to the target, the base or an operation's "
            "starts than this. [ours: room for the team]"});
  v.integer("seed", obstacles.seed, {0, 9e15},
            {"", "Seed of the field alone; 0 follows the run's seed. [MissionLab]"});
  v.rows("discs", obstacles.discs, kDiscColumns, {-1e5, 1e5},
         {"m", "Obstacles at given places, beside those placed by chance. [MissionLab]"});
}

void describe_start(RobotConfig& robots, ParameterVisitor& v) {
  v.choice("start", robots.start, kStarts,
           {"",
            "On a ring round the target or the base, scattered over the area, or gathered as near "
            "the target or the base as there is room. [ours]"});
  v.number("ring_radius_m", robots.ring_radius_m, {0, 100000},
           {"m", "Radius of the starting ring. [ours]"});
}

// In an operation every robot has a start of its own.
void describe_robots(WorldConfig& config, ParameterVisitor& v) {
  RobotConfig& robots = config.robots;
  v.section("robots", "The team's bodies.");
  v.integer("count", robots.count, {1, 10000}, {"", "Size of the team. [paper: 1, 2, 3, 6]"});
  if (config.mission != MissionKind::Operation) {
    describe_start(robots, v);
  }
  v.number("radius_m", robots.radius_m, {0.01, 100}, {"m", "Body radius. [MissionLab]"});
  v.number("max_speed_mps", robots.max_speed_mps, {0.001, 1000},
           {"m/s", "What the wheels can do. [ours]"});
  v.number("max_acceleration_mps2", robots.max_acceleration_mps2, {0.001, 10000},
           {"m/s2", "Limit on every change of velocity. [ours]"});
  v.number("max_turn_radps", robots.max_turn_radps, {0.001, 1000},
           {"rad/s", "What the wheels can do. [ours]"});
}

void describe_sight(SightConfig& sight, ParameterVisitor& v) {
  v.section("sight", "What the robots' sensors reach.");
  v.number("range_m", sight.range_m, {0, 100000}, {"m", "Of recognising things. [ours]"});
  v.number("field_of_view_deg", sight.field_of_view_deg, {1, 360},
           {"deg", "Of recognising things, centred ahead. [ours: panoramic]"});
  v.flag("blocked_by_walls", sight.blocked_by_walls, {"", "Walls hide things. [MissionLab]"});
  v.flag("blocked_by_obstacles", sight.blocked_by_obstacles,
         {"", "Obstacles hide things. [ours: MissionLab sees through obstacles]"});
  v.number("obstacle_range_m", sight.obstacle_range_m, {0, 1000},
           {"m", "Of the range finder, to the obstacle's surface. [ours]"});
  v.number("range_noise_m", sight.range_noise_m, {0, 100},
           {"m", "Standard deviation of a sighting's range. [ours]"});
  v.number("bearing_noise_deg", sight.bearing_noise_deg, {0, 90},
           {"deg", "Standard deviation of a sighting's bearing. [ours]"});
}

void describe_enemy_rules(EnemyConfig& enemies, ParameterVisitor& v) {
  v.integer("strategy", enemies.strategy, {0, 5},
            {"", "Attack strategy 1 to 5; 0 for no enemies at all. [paper]"});
  v.number("period_scale", enemies.period_scale, {0.01, 1000},
           {"", "Multiplies the strategy's own spawn periods. [ours]"});
  v.number("spawn_jitter_m", enemies.spawn_jitter_m, {0, 1000},
           {"m", "How far along the rim a spawn place may shift, either way. [ours]"});
  v.integer("max_alive", enemies.max_alive, {0, 1000},
            {"", "No enemy is created while so many are alive. [ours]"});
  v.number("kill_radius_m", enemies.kill_radius_m, {0.01, 1000},
           {"m", "A robot this near destroys an enemy, centre to centre. [ours]"});
  v.number("hit_radius_m", enemies.hit_radius_m, {0.01, 1000},
           {"m", "An enemy this near has reached the target, centre to centre. [ours]"});
}

void describe_enemies(EnemyConfig& enemies, ParameterVisitor& v) {
  v.section("enemies", "Who attacks the target.");
  describe_enemy_rules(enemies, v);
  v.number("speed_mps", enemies.speed_mps, {0, 1000},
           {"m/s", "Of normal enemies and decoys. [ours: 0.85 of the robots']"});
  v.number("radius_m", enemies.radius_m, {0.01, 100}, {"m", "Body radius. [MissionLab]"});
  v.number("sight_range_m", enemies.sight_range_m, {0, 100000},
           {"m", "From how far an enemy sees the target. [ours]"});
  v.flag("sight_blocked_by_walls", enemies.sight_blocked_by_walls,
         {"", "Walls hide the target from enemies. [MissionLab]"});
  v.flag("sight_blocked_by_obstacles", enemies.sight_blocked_by_obstacles,
         {"", "Obstacles hide the target from enemies. [MissionLab: no]"});
  v.number("avoid_reach_m", enemies.avoid_reach_m, {0, 1000},
           {"m", "Distance from a surface at which it starts to repel. [MissionLab]"});
  v.number("avoid_margin_m", enemies.avoid_margin_m, {0, 1000},
           {"m", "Distance from a surface at which it repels fully. [MissionLab]"});
  v.number("noise_gain", enemies.noise_gain, {0, 10},
           {"", "Weight of a random heading, against standstill behind obstacles. [ours]"});
  v.number("wander_hold_s", enemies.wander_hold_s, {0.01, 10000},
           {"s", "How long a random heading is held. [ours]"});
  v.number("decoy_tether_m", enemies.decoy_tether_m, {0, 100000},
           {"m", "A decoy turns back when so far from where it appeared. [ours]"});
}

void describe_physics(PhysicsConfig& physics, ParameterVisitor& v) {
  v.section("physics", "Time.");
  v.number("tick_s", physics.tick_s, {0.001, 10}, {"s", "One control cycle. [MissionLab]"});
  v.integer("substeps", physics.substeps, {1, 100},
            {"", "Bullet steps per tick. [ours: a body moves less than its radius in one]"});
  v.integer("checkpoint_ticks", physics.checkpoint_ticks, {1, 1e9},
            {"ticks", "Distance between checkpoints in the event log. [ours]"});
}

void check_focus(const WorldConfig& config, const std::string& section) {
  const FocusPoint middle = focus(config);
  const double ring_m = config.robots.ring_radius_m;
  refuse(!config.area.holds(middle.x_m, middle.y_m),
         section + " x_m, y_m lie outside the area; wanted a point in it");
  refuse(config.robots.start == "ring" &&
             !(config.area.holds(middle.x_m - ring_m, middle.y_m - ring_m) &&
               config.area.holds(middle.x_m + ring_m, middle.y_m + ring_m)),
         "[robots] ring_radius_m reaches outside the area; wanted the whole ring in it");
}

void check_terrain(const WorldConfig& config) {
  for (const auto& wall : config.area.walls) {
    refuse(!config.area.holds(wall[0], wall[1]) || !config.area.holds(wall[2], wall[3]),
           "[area] walls holds a point outside the area; wanted all inside");
  }
  for (const auto& disc : config.obstacles.discs) {
    refuse(disc[2] <= 0, "[obstacles] discs holds a radius that is not positive; wanted r > 0");
    refuse(!config.area.holds(disc[0], disc[1]),
           "[obstacles] discs holds a centre outside the area; wanted all inside");
  }
}

void settle_for_forage(WorldConfig& config) {
  config.area.width_m = 60.0;
  config.area.height_m = 60.0;
  config.obstacles = {0.0, 0.5, 2.0, 4.0, 0, {}};
  config.robots.ring_radius_m = 2.0;
  config.robots.max_speed_mps = 0.5;
  config.sight.range_m = 50.0;
  config.sight.obstacle_range_m = 3.0;
  config.physics.tick_s = 1.0;
  config.physics.substeps = 3;
  config.physics.checkpoint_ticks = 1000;
}

// MissionLab's robots, in buildings: walls hide things, obstacles do not.
void settle_for_operation(WorldConfig& config) {
  config.obstacles.coverage_percent = 0.0;
  config.obstacles.keep_free_m = 2.0;
  config.robots.radius_m = 0.2;
  config.robots.max_speed_mps = 1.0;
  config.sight.range_m = 50.0;
  config.sight.blocked_by_obstacles = false;
  config.sight.obstacle_range_m = 5.0;
}

}  // namespace

void describe(WorldConfig& config, ParameterVisitor& visitor) {
  describe_area(config.area, visitor);
  if (config.mission == MissionKind::Guard) {
    describe_target(config.target, visitor);
  }
  describe_obstacles(config.obstacles, visitor);
  describe_robots(config, visitor);
  describe_sight(config.sight, visitor);
  switch (config.mission) {
    case MissionKind::Guard:
      describe_enemies(config.enemies, visitor);
      break;
    case MissionKind::Forage:
      describe(config.forage, visitor);
      break;
    case MissionKind::Operation:
      describe(config.operation, visitor);
      break;
  }
  describe_physics(config.physics, visitor);
}

WorldConfig world_defaults(MissionKind mission) {
  WorldConfig config;
  config.mission = mission;
  switch (mission) {
    case MissionKind::Guard:
      break;
    case MissionKind::Forage:
      settle_for_forage(config);
      break;
    case MissionKind::Operation:
      settle_for_operation(config);
      break;
  }
  return config;
}

FocusPoint focus(const WorldConfig& config) {
  switch (config.mission) {
    case MissionKind::Guard:
      return {config.target.x_m, config.target.y_m};
    case MissionKind::Forage:
      return {config.forage.base.x_m, config.forage.base.y_m};
    case MissionKind::Operation:
      break;
  }
  return {config.area.width_m / 2.0, config.area.height_m / 2.0};
}

void check(const WorldConfig& config) {
  refuse(config.obstacles.min_radius_m > config.obstacles.max_radius_m,
         "[obstacles] min_radius_m is larger than max_radius_m; wanted min <= max");
  switch (config.mission) {
    case MissionKind::Guard:
      check_focus(config, "[target]");
      refuse(config.enemies.avoid_margin_m >= config.enemies.avoid_reach_m,
             "[enemies] avoid_margin_m is not below avoid_reach_m; wanted margin < reach");
      break;
    case MissionKind::Forage:
      check_focus(config, "[base]");
      check(config.forage, config.area);
      break;
    case MissionKind::Operation:
      check(config.operation, config.robots.count);
      break;
  }
  check_terrain(config);
}

}  // namespace tacit
