#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "idl/types/mission_kind.h"
#include "idl/types/parameters.h"
#include "world_server/world/forage_config.h"
#include "world_server/world/operation_config.h"

namespace tacit {

/// How far and through what someone sees.
struct SightConfig {
  double range_m = 75.0;
  double field_of_view_deg = 360.0;
  bool blocked_by_walls = true;
  bool blocked_by_obstacles = true;
  double obstacle_range_m = 10.0;
  double range_noise_m = 0.0;
  double bearing_noise_deg = 0.0;
};

struct AreaConfig {
  std::string map;  ///< File from which area, walls and obstacles come; empty once taken.
  std::string doors = "open";  ///< "open" or "closed", on a map.
  double width_m = 200.0;
  double height_m = 200.0;
  bool border_walls = true;
  std::vector<std::vector<double>> walls;  ///< Rows of x1, y1, x2, y2.

  /// Whether a point lies in the area or on its border.
  [[nodiscard]] bool holds(double x_m, double y_m) const {
    return x_m >= 0 && y_m >= 0 && x_m <= width_m && y_m <= height_m;
  }
};

struct TargetConfig {
  double x_m = 100.0;
  double y_m = 100.0;
  double radius_m = 1.0;
};

struct ObstacleConfig {
  double coverage_percent = 3.0;
  double min_radius_m = 1.0;
  double max_radius_m = 5.0;
  double keep_free_m = 20.0;
  std::int64_t seed = 0;
  std::vector<std::vector<double>> discs;  ///< Rows of x, y, r.
};

struct RobotConfig {
  std::int64_t count = 6;
  std::string start = "ring";
  double ring_radius_m = 10.0;
  double radius_m = 0.2;
  double max_speed_mps = 2.0;
  double max_acceleration_mps2 = 4.0;
  double max_turn_radps = 6.0;
};

struct EnemyConfig {
  std::int64_t strategy = 1;
  double speed_mps = 1.7;
  double radius_m = 0.2;
  double sight_range_m = 300.0;
  bool sight_blocked_by_walls = true;
  bool sight_blocked_by_obstacles = false;
  double kill_radius_m = 2.0;
  double hit_radius_m = 2.0;
  double period_scale = 1.0;
  double spawn_jitter_m = 5.0;
  double avoid_reach_m = 3.0;
  double avoid_margin_m = 0.5;
  double noise_gain = 0.15;
  double wander_hold_s = 5.0;
  double decoy_tether_m = 15.0;
  std::int64_t max_alive = 400;
};

struct PhysicsConfig {
  double tick_s = 0.1;
  std::int64_t substeps = 1;
  std::int64_t checkpoint_ticks = 100;
};

/// Everything a world is made from, beside its seed. Of `target` and `enemies`, of `forage` and of
/// `operation`, only what the mission is about counts.
struct WorldConfig {
  MissionKind mission = MissionKind::Guard;
  AreaConfig area;
  TargetConfig target;
  ObstacleConfig obstacles;
  RobotConfig robots;
  SightConfig sight;
  EnemyConfig enemies;
  ForageConfig forage;
  OperationConfig operation;
  PhysicsConfig physics;
};

/// The defaults for a mission.
[[nodiscard]] WorldConfig world_defaults(MissionKind mission);

/// The place that the mission is about: the target to guard, or the base; the middle of the area
/// in an operation, which is about no one place.
struct FocusPoint {
  double x_m = 0.0;
  double y_m = 0.0;
};
[[nodiscard]] FocusPoint focus(const WorldConfig& config);

/// Names every parameter that the mission has, with unit, range, meaning and source.
void describe(WorldConfig& config, ParameterVisitor& visitor);

/// Throws ConfigError when values that are each in range contradict one another.
void check(const WorldConfig& config);

}  // namespace tacit
