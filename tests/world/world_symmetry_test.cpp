#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

// A collision multiplies rounding errors, and a world turned or moved rounds otherwise.
constexpr double kClose_m = 1e-6;
constexpr Tick kTicks = 400;
constexpr std::int64_t kTeam = 4;

WorldConfig open_world() {
  WorldConfig config = empty_world(kTeam);
  config.area.border_walls = false;
  config.robots.ring_radius_m = 6.0;
  config.obstacles.discs = {{60.0, 52.0, 2.0}, {50.0, 63.0, 3.0}, {41.0, 40.0, 1.0}};
  return config;
}

std::vector<ViewedRobot> robots_of(const World& world) {
  WorldView view;
  world.view(view);
  return view.robots;
}

// Sightings as sorted numbers, since the order of the lists means nothing.
std::vector<std::pair<double, double>> rounded(const std::vector<Sighting>& sightings) {
  std::vector<std::pair<double, double>> out;
  for (const Sighting& s : sightings) {
    out.emplace_back(s.offset_m.x(), s.offset_m.y());
  }
  std::sort(out.begin(), out.end());
  return out;
}

void expect_alike(const Percept& a, const Percept& b) {
  EXPECT_NEAR((a.velocity_mps - b.velocity_mps).norm(), 0.0, kClose_m);
  EXPECT_NEAR((a.odometry.position_m - b.odometry.position_m).norm(), 0.0, kClose_m);
  EXPECT_EQ(a.touching, b.touching);
  EXPECT_EQ(a.obstacles.size(), b.obstacles.size());
  const auto seen_a = rounded(a.sightings);
  const auto seen_b = rounded(b.sightings);
  ASSERT_EQ(seen_a.size(), seen_b.size());
  for (std::size_t i = 0; i < seen_a.size(); ++i) {
    EXPECT_NEAR(seen_a[i].first, seen_b[i].first, kClose_m);
    EXPECT_NEAR(seen_a[i].second, seen_b[i].second, kClose_m);
  }
}

TEST(Worlds, MovedElsewhereHaveTheSameHistory) {
  constexpr double kEast_m = 43.0;
  constexpr double kNorth_m = 17.0;
  const WorldConfig config = open_world();
  WorldConfig moved = config;
  moved.area.width_m += 2.0 * kEast_m;
  moved.area.height_m += 2.0 * kNorth_m;
  moved.target.x_m += kEast_m;
  moved.target.y_m += kNorth_m;
  for (auto& disc : moved.obstacles.discs) {
    disc[0] += kEast_m;
    disc[1] += kNorth_m;
  }
  World here(config, 1);
  World there(moved, 1);
  Stream chance(1, "commands");
  for (Tick tick = 0; tick < kTicks; ++tick) {
    const std::vector<Command> commands = random_commands(kTeam, tick, chance);
    here.step(commands);
    there.step(commands);
    for (std::size_t i = 0; i < kTeam; ++i) {
      expect_alike(here.percepts()[i], there.percepts()[i]);
      const WorldVec apart =
          robots_of(there)[i].pose.position_m - robots_of(here)[i].pose.position_m;
      ASSERT_NEAR((apart - WorldVec{kEast_m, kNorth_m}).norm(), 0.0, kClose_m);
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << "tick " << tick;
  }
}

// Four robots on a ring: a quarter turn puts robot i where robot i + 1 stood.
TEST(Worlds, TurnedByAQuarterHaveTheSameHistoryWithTheRobotsRenamed) {
  const WorldConfig config = open_world();
  WorldConfig turned = config;
  const auto quarter = [](double x, double y) {
    return WorldVec{50.0 - (y - 50.0), 50.0 + (x - 50.0)};
  };
  for (auto& disc : turned.obstacles.discs) {
    const WorldVec centre = quarter(disc[0], disc[1]);
    disc = {centre.x(), centre.y(), disc[2]};
  }
  World here(config, 1);
  World there(turned, 1);
  Stream chance(2, "commands");
  const auto next = [](std::size_t i) { return (i + 1) % kTeam; };
  for (Tick tick = 0; tick < kTicks; ++tick) {
    std::vector<Command> commands = random_commands(kTeam, tick, chance);
    here.step(commands);
    for (Command& command : commands) {
      command.robot.value = static_cast<std::uint16_t>(next(command.robot.value - 1u) + 1);
    }
    there.step(commands);
    for (std::size_t i = 0; i < kTeam; ++i) {
      expect_alike(here.percepts()[i], there.percepts()[next(i)]);
      const WorldVec place = robots_of(here)[i].pose.position_m;
      const WorldVec image = robots_of(there)[next(i)].pose.position_m;
      ASSERT_NEAR((quarter(place.x(), place.y()) - image).norm(), 0.0, kClose_m);
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << "tick " << tick;
  }
}

}  // namespace
}  // namespace tacit
