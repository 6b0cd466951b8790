#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tests/world/sample_worlds.h"
#include "world_server/world/sensing/senses.h"

namespace tacit {

/// A scene set by hand: robot 1 looks, the other robots and the enemies are looked at.
struct Lookout {
  WorldConfig config = empty_world(1);
  Terrain terrain{100.0, 100.0, false, {}, {}};
  WorldPose eye{{20.0, 20.0}, {}};
  std::vector<WorldVec> enemies;
  std::vector<WorldPose> teammates;

  // A stage in which nothing but the enemies is in sight.
  Lookout() {
    config.sight.range_m = 30.0;
    config.target.x_m = 90.0;
    config.target.y_m = 90.0;
  }

  [[nodiscard]] Percept percept(std::uint64_t seed = 1, int looks = 1) {
    config.robots.count = static_cast<std::int64_t>(1 + teammates.size());
    std::vector<WorldVec> places{eye.position_m};
    std::vector<Heading> headings{eye.heading};
    for (const WorldPose& mate : teammates) {
      places.push_back(mate.position_m);
      headings.push_back(mate.heading);
    }
    places.insert(places.end(), enemies.begin(), enemies.end());
    std::vector<Look> bodies(headings.size(),
                             {Kind::Teammate, Colour::Blue, config.robots.radius_m});
    bodies.resize(places.size(), {Kind::Enemy, Colour::Red, config.enemies.radius_m});
    const Landmark target{{config.target.x_m, config.target.y_m},
                          {Kind::Target, Colour::White, config.target.radius_m}};
    BodyGrid grid(terrain.width_m, terrain.height_m, config.sight.range_m);
    grid.rebuild(places);
    Senses senses(config, terrain, seed);
    Percept out;
    for (int i = 0; i < looks; ++i) {
      senses.sense({places, headings, bodies, &grid, std::span(&target, 1), {}}, 0, out);
    }
    return out;
  }
  [[nodiscard]] std::size_t seen() { return percept().sightings.size(); }
};

}  // namespace tacit
