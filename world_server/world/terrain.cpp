#include "world_server/world/terrain.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

#include "idl/types/config_error.h"
#include "idl/types/random.h"

namespace tacit {
namespace {

bool overlaps(const Disc& disc, const std::vector<Disc>& others) {
  return std::any_of(others.begin(), others.end(), [&disc](const Disc& other) {
    const double reach = disc.radius_m + other.radius_m;
    return (disc.centre_m - other.centre_m).squared_norm() < reach * reach;
  });
}

bool near_focus(const Disc& disc, const WorldConfig& config) {
  const FocusPoint point = focus(config);
  const WorldVec centre{point.x_m, point.y_m};
  return (disc.centre_m - centre).norm() < config.obstacles.keep_free_m + disc.radius_m;
}

bool near_start(const Disc& disc, const WorldConfig& config) {
  const OperationConfig& operation = config.operation;
  const WorldVec shift{operation.shift_x_m, operation.shift_y_m};
  const double free_m = config.obstacles.keep_free_m + disc.radius_m;
  const auto& starts = operation.script.starts;
  return std::any_of(starts.begin(), starts.end(), [&](const std::vector<double>& row) {
    return (disc.centre_m - shift - WorldVec{row[0], row[1]}).norm() < free_m;
  });
}

// The team needs room where it begins.
bool near_team(const Disc& disc, const WorldConfig& config) {
  return config.mission == MissionKind::Operation ? near_start(disc, config)
                                                  : near_focus(disc, config);
}

// Mines at given places must stay within a robot's reach.
bool near_given_mine(const Disc& disc, const WorldConfig& config) {
  const auto& places = config.forage.mines.places;
  return config.mission == MissionKind::Forage &&
         std::any_of(places.begin(), places.end(), [&](const std::vector<double>& row) {
           const double away_m = (disc.centre_m - WorldVec{row[0], row[1]}).norm();
           return away_m < disc.radius_m + mine_clearance_m(config);
         });
}

bool near_wall(const Disc& disc, const std::vector<Wall>& walls) {
  return std::any_of(walls.begin(), walls.end(), [&disc](const Wall& wall) {
    return (nearest_point(wall, disc.centre_m) - disc.centre_m).norm() < disc.radius_m;
  });
}

std::optional<Disc> place_disc(const WorldConfig& config, const Terrain& terrain, Stream& chance) {
  constexpr int kTries = 1000;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const double r = chance.uniform(config.obstacles.min_radius_m, config.obstacles.max_radius_m);
    const double x = r + (terrain.width_m - 2.0 * r) * chance.uniform();
    const double y = r + (terrain.height_m - 2.0 * r) * chance.uniform();
    const Disc disc{{x, y}, r};
    const bool fits = 2.0 * r <= std::min(terrain.width_m, terrain.height_m);
    if (fits && !near_team(disc, config) && !near_given_mine(disc, config) &&
        !overlaps(disc, terrain.obstacles) && !near_wall(disc, terrain.walls)) {
      return disc;
    }
  }
  return std::nullopt;
}

[[noreturn]] void refuse_coverage(double wanted_percent, double reached_percent) {
  char text[160];
  std::snprintf(text, sizeof text,
                "[obstacles] coverage_percent = %g cannot be placed: only %.1f %% of the area is "
                "free enough; wanted less, or smaller obstacles or keep_free_m",
                wanted_percent, reached_percent);
  throw ConfigError(text);
}

void scatter_discs(const WorldConfig& config, Stream chance, Terrain& terrain) {
  const double area_m2 = terrain.width_m * terrain.height_m;
  const double wanted_m2 = config.obstacles.coverage_percent / 100.0 * area_m2;
  double covered_m2 = 0.0;
  while (covered_m2 < wanted_m2) {
    const std::optional<Disc> disc = place_disc(config, terrain, chance);
    if (!disc) {
      refuse_coverage(config.obstacles.coverage_percent, 100.0 * covered_m2 / area_m2);
    }
    terrain.obstacles.push_back(*disc);
    covered_m2 += kPi * disc->radius_m * disc->radius_m;
  }
}

}  // namespace

double mine_clearance_m(const WorldConfig& config) { return 3.0 * config.robots.radius_m; }

Terrain make_terrain(const WorldConfig& config, std::uint64_t seed) {
  Terrain terrain{config.area.width_m, config.area.height_m, config.area.border_walls, {}, {}};
  for (const auto& row : config.area.walls) {
    terrain.walls.push_back({{row[0], row[1]}, {row[2], row[3]}});
  }
  for (const auto& row : config.obstacles.discs) {
    terrain.obstacles.push_back({{row[0], row[1]}, row[2]});
  }
  const auto own_seed = static_cast<std::uint64_t>(config.obstacles.seed);
  scatter_discs(config, Stream(own_seed != 0 ? own_seed : seed, "obstacle field"), terrain);
  return terrain;
}

WorldVec nearest_point(const Wall& wall, const WorldVec& p) {
  const WorldVec along = wall.to_m - wall.from_m;
  const double length2 = along.squared_norm();
  const double t = length2 > 0.0 ? (p - wall.from_m).dot(along) / length2 : 0.0;
  return wall.from_m + std::clamp(t, 0.0, 1.0) * along;
}

double clearance_m(const Terrain& terrain, const WorldVec& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Disc& disc : terrain.obstacles) {
    least = std::min(least, (disc.centre_m - p).norm() - disc.radius_m);
  }
  for (const Wall& wall : terrain.walls) {
    least = std::min(least, (nearest_point(wall, p) - p).norm());
  }
  return least;
}

WorldVec rim_place(const Terrain& terrain, double inset_m, double share) {
  const double w = std::max(0.0, terrain.width_m - 2.0 * inset_m);
  const double h = std::max(0.0, terrain.height_m - 2.0 * inset_m);
  const double along = share * 2.0 * (w + h);
  const WorldVec corner{inset_m, inset_m};
  if (along < w) return corner + WorldVec{along, 0.0};
  if (along < w + h) return corner + WorldVec{w, along - w};
  if (along < 2.0 * w + h) return corner + WorldVec{2.0 * w + h - along, h};
  return corner + WorldVec{0.0, 2.0 * (w + h) - along};
}

}  // namespace tacit
