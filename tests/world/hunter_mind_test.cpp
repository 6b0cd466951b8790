#include "world_server/world/enemies/hunter_mind.h"

#include <gtest/gtest.h>

#include "tests/world/forage_field.h"

namespace tacit {
namespace {

struct Chase {
  WorldConfig config = bare_field(1);
  Terrain terrain{40.0, 40.0, true, {}, {}};
  WorldVec place_m{5.0, 20.0};
  WorldVec goal_m{35.0, 20.0};

  // Ticks until the hunter is within half a metre of its goal.
  [[nodiscard]] int ticks(std::uint64_t seed, int patience) const {
    HunterMind mind(config, terrain);
    Wander wander{Stream(seed, "hunter heading", 1), {}, 0};
    WorldVec place = place_m;
    for (int tick = 0; tick < patience; ++tick) {
      if ((place - goal_m).norm() <= 0.5) {
        return tick;
      }
      place +=
          config.physics.tick_s * mind.velocity(wander, place, goal_m, static_cast<Tick>(tick));
    }
    return patience;
  }
};

TEST(HunterMind, GetsRoundADiscDeadAhead) {
  for (const double radius_m : {0.5, 2.0, 5.0}) {
    Chase chase;
    chase.terrain.obstacles = {{{20.0, 20.0}, radius_m}};
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      // Three times the straight way's time.
      ASSERT_LT(chase.ticks(seed, 360), 360) << radius_m << " seed " << seed;
    }
  }
}

TEST(HunterMind, GetsRoundAWallInBetween) {
  Chase chase;
  chase.terrain.walls = {{{20.0, 15.0}, {20.0, 25.0}}};
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    ASSERT_LT(chase.ticks(seed, 4000), 4000) << seed;
  }
}

TEST(HunterMind, DoesNotRunBeyondItsGoal) {
  Chase chase;
  chase.config.forage.hunters.speed_mps = 100.0;
  EXPECT_LT(chase.ticks(1, 20), 20);
}

TEST(HunterMind, StaysWhereItsGoalIs) {
  const Chase chase;
  HunterMind mind(chase.config, chase.terrain);
  Wander wander{Stream(1, "hunter heading", 1), {}, 0};
  EXPECT_EQ(mind.velocity(wander, chase.place_m, chase.place_m, 0), WorldVec{});
}

}  // namespace
}  // namespace tacit
