#include "world_server/world/start.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>

#include "idl/types/config_error.h"
#include "idl/types/random.h"

namespace tacit {
namespace {

bool free_of_terrain(const WorldVec& p, double radius_m, const Terrain& terrain) {
  const bool clear_of_discs = std::none_of(
      terrain.obstacles.begin(), terrain.obstacles.end(),
      [&](const Disc& disc) { return (disc.centre_m - p).norm() < disc.radius_m + radius_m; });
  return clear_of_discs &&
         std::none_of(terrain.walls.begin(), terrain.walls.end(), [&](const Wall& wall) {
           return (nearest_point(wall, p) - p).norm() < radius_m;
         });
}

bool free_of_robots(const WorldVec& p, double radius_m, const std::vector<WorldPose>& robots) {
  return std::none_of(robots.begin(), robots.end(), [&](const WorldPose& other) {
    return (other.position_m - p).norm() < 2.0 * radius_m;
  });
}

WorldPose on_ring(const WorldConfig& config, std::size_t index) {
  const double share = static_cast<double>(index) / static_cast<double>(config.robots.count);
  const Heading outward = Heading::from_rad(2.0 * kPi * share);
  const FocusPoint point = focus(config);
  const WorldVec centre{point.x_m, point.y_m};
  return {centre + config.robots.ring_radius_m * WorldVec{outward.cos, outward.sin}, outward};
}

WorldPose anywhere(const WorldConfig& config, Stream& chance) {
  const double r = config.robots.radius_m;
  const double x = chance.uniform(r, config.area.width_m - r);
  const double y = chance.uniform(r, config.area.height_m - r);
  return {{x, y}, Heading::from_rad(chance.uniform(-kPi, kPi))};
}

/// Looks for room near the target or base, on a grid fine enough that no robot that goes from place
/// to place could slip through a wall: all stand where all others can be reached.
class Gathering {
 public:
  Gathering(const WorldConfig& config, const Terrain& terrain)
      : config_(config),
        terrain_(terrain),
        radius_m_(config.robots.radius_m),
        centre_m_(focus(config).x_m, focus(config).y_m) {}

  /// As many as there is room for.
  std::vector<WorldPose> poses() {
    std::vector<WorldPose> most;
    for (int ring = 0; ring <= kRings; ++ring) {
      for (int i = -ring; i <= ring; ++i) {
        const int step = std::abs(i) == ring ? 1 : std::max(1, 2 * ring);
        for (int j = -ring; j <= ring; j += step) {
          std::vector<WorldPose> found = around({i, j});
          if (found.size() == count()) return found;
          if (found.size() > most.size()) most = std::move(found);
        }
      }
    }
    return most;
  }

 private:
  using Cell = std::pair<int, int>;
  static constexpr int kRings = 200;         ///< [ours: so long a search takes about a second]
  static constexpr double kFineness = 1.9;   ///< Below 2 radii no wall fits between neighbours.
  static constexpr double kElbowRoom = 3.0;  ///< Radii from robot to robot. [ours]

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(config_.robots.count); }

  [[nodiscard]] WorldVec place(const Cell& cell) const {
    const double step_m = kFineness * radius_m_;
    return centre_m_ + WorldVec{step_m * cell.first, step_m * cell.second};
  }

  /// Whether nobody has been at `cell` and a robot can stand there.
  bool enters(const Cell& cell) {
    const WorldVec p = place(cell);
    const bool inside = p.x() >= radius_m_ && p.y() >= radius_m_ &&
                        p.x() <= terrain_.width_m - radius_m_ &&
                        p.y() <= terrain_.height_m - radius_m_;
    return inside && known_.insert(cell).second && free_of_terrain(p, radius_m_, terrain_);
  }

  std::vector<WorldPose> around(const Cell& first) {
    std::vector<WorldPose> poses;
    std::vector<Cell> queue;
    if (enters(first)) queue.push_back(first);
    for (std::size_t next = 0; next < queue.size() && poses.size() < count(); ++next) {
      const Cell cell = queue[next];
      if (free_of_robots(place(cell), kElbowRoom * radius_m_ / 2.0, poses)) {
        poses.push_back({place(cell), outward(place(cell))});
      }
      for (const auto& [di, dj] : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}}) {
        const Cell neighbour{cell.first + di, cell.second + dj};
        if (enters(neighbour)) queue.push_back(neighbour);
      }
    }
    return poses;
  }

  [[nodiscard]] Heading outward(const WorldVec& p) const {
    const WorldVec away = unit(p - centre_m_);
    return away.squared_norm() > 0.0 ? Heading{away.x(), away.y()} : Heading{};
  }

  const WorldConfig& config_;
  const Terrain& terrain_;
  double radius_m_;
  WorldVec centre_m_;
  std::set<Cell> known_;
};

[[noreturn]] void refuse(const WorldConfig& config, std::size_t robots) {
  throw ConfigError("[robots] count = " + std::to_string(config.robots.count) +
                    ": no room for robot " + std::to_string(robots + 1) +
                    "; wanted fewer or smaller robots, a wider ring_radius_m or a larger "
                    "[obstacles] keep_free_m");
}

std::vector<WorldPose> gathered(const WorldConfig& config, const Terrain& terrain) {
  std::vector<WorldPose> poses = Gathering(config, terrain).poses();
  if (poses.size() < static_cast<std::size_t>(config.robots.count)) {
    refuse(config, poses.size());
  }
  return poses;
}

/// What is wrong with the place of the robot that comes after `others`; empty when nothing is.
std::string flaw_of(const WorldVec& p, const WorldConfig& config, const Terrain& terrain,
                    const std::vector<WorldPose>& others) {
  const double r = config.robots.radius_m;
  if (!(p.x() >= r && p.y() >= r && p.x() <= terrain.width_m - r &&
        p.y() <= terrain.height_m - r)) {
    return "it is outside the area of " + std::to_string(terrain.width_m) + " m by " +
           std::to_string(terrain.height_m) + " m, or too near its border";
  }
  if (!free_of_terrain(p, r, terrain)) {
    return "a wall or an obstacle is there";
  }
  return free_of_robots(p, r, others) ? "" : "another robot before it is there";
}

std::vector<WorldPose> as_told(const WorldConfig& config, const Terrain& terrain) {
  const WorldVec shift{config.operation.shift_x_m, config.operation.shift_y_m};
  std::vector<WorldPose> poses;
  for (const std::vector<double>& row : config.operation.script.starts) {
    const WorldPose pose{WorldVec{row[0], row[1]} + shift, Heading::from_rad(row[2] * kPi / 180.0)};
    const std::string flaw = flaw_of(pose.position_m, config, terrain, poses);
    if (!flaw.empty()) {
      throw ConfigError("[operation] starts: robot " + std::to_string(poses.size() + 1) + " at " +
                        std::to_string(row[0]) + ", " + std::to_string(row[1]) + ": " + flaw +
                        "; wanted a free place");
    }
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace

std::vector<WorldPose> start_poses(const WorldConfig& config, const Terrain& terrain,
                                   std::uint64_t seed) {
  if (config.mission == MissionKind::Operation) {
    return as_told(config, terrain);
  }
  if (config.robots.start == "gathered") {
    return gathered(config, terrain);
  }
  const bool ring = config.robots.start == "ring";
  const int tries = ring ? 1 : 1000;
  Stream chance(seed, "start places");
  std::vector<WorldPose> poses;
  for (std::size_t i = 0; i < static_cast<std::size_t>(config.robots.count); ++i) {
    bool placed = false;
    for (int attempt = 0; attempt < tries && !placed; ++attempt) {
      const WorldPose pose = ring ? on_ring(config, i) : anywhere(config, chance);
      placed = free_of_terrain(pose.position_m, config.robots.radius_m, terrain) &&
               free_of_robots(pose.position_m, config.robots.radius_m, poses);
      if (placed) {
        poses.push_back(pose);
      }
    }
    if (!placed) {
      refuse(config, i);
    }
  }
  return poses;
}

}  // namespace tacit
