#include "deploy/lockstep/environment.h"

#include <algorithm>
#include <array>
#include <string>

#include "idl/types/random.h"

namespace tacit {
namespace {

/// A start ring fits round a base that is so far from every border.
constexpr double kRoom_m = 6.0;
/// Longer than a mission can take, whose ticks of a second are capped.
constexpr double kDuration_s = 1e6;

void draw_mines(MineConfig& mines, Stream& chance) {
  constexpr std::array<const char*, 3> kLayouts{"scattered", "clusters", "ring"};
  mines.count = 10 + static_cast<std::int64_t>(chance.below(21));
  mines.layout = kLayouts[chance.below(kLayouts.size())];
  mines.clusters = 1 + static_cast<std::int64_t>(chance.below(5));
  mines.cluster_radius_m = chance.uniform(3.0, 6.0);
  mines.keep_from_base_m = chance.uniform(4.0, 12.0);
}

/// Half of all bases lie in the middle.
void draw_base(WorldConfig& world, Stream& chance) {
  const bool middle = chance.below(2) == 0;
  const double x_m = chance.uniform(kRoom_m, world.area.width_m - kRoom_m);
  const double y_m = chance.uniform(kRoom_m, world.area.height_m - kRoom_m);
  world.forage.base.x_m = middle ? 0.5 * world.area.width_m : x_m;
  world.forage.base.y_m = middle ? 0.5 * world.area.height_m : y_m;
}

/// A third of all fields are open.
void draw_obstacles(ObstacleConfig& obstacles, Stream& chance) {
  obstacles.coverage_percent = std::max(0.0, chance.uniform(-2.0, 4.0));
}

}  // namespace

Setup drawn_environment(std::int64_t seed) {
  Stream chance(static_cast<std::uint64_t>(seed), "environment");
  Setup setup = setup_for(MissionKind::Forage);
  setup.run.duration_s = kDuration_s;
  setup.run.name = "forage_" + std::to_string(seed);
  setup.run.description = "An environment drawn by chance, number " + std::to_string(seed);
  draw_mines(setup.world.forage.mines, chance);
  draw_base(setup.world, chance);
  draw_obstacles(setup.world.obstacles, chance);
  setup.world.forage.mines.seed = seed;
  setup.world.obstacles.seed = seed;
  return setup;
}

}  // namespace tacit
