#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

constexpr Tick kTicks = 600;

struct History {
  std::uint64_t digest = 0;
  std::vector<Event> events;
  friend bool operator==(const History&, const History&) = default;
};

// What a world does under random commands that depend on nothing it tells.
History played(const WorldConfig& config, std::uint64_t seed, std::uint64_t command_seed = 1) {
  World world(config, seed);
  Stream chance(command_seed, "commands");
  History history;
  for (Tick tick = 0; tick < kTicks; ++tick) {
    const auto events = world.step(random_commands(config.robots.count, tick, chance));
    history.events.insert(history.events.end(), events.begin(), events.end());
  }
  history.digest = world.digest();
  return history;
}

template <class Kind>
std::ptrdiff_t count_of(std::span<const Event> events) {
  return std::count_if(events.begin(), events.end(),
                       [](const Event& e) { return std::holds_alternative<Kind>(e.what); });
}

TEST(World, IsTheSameForTheSameSeedAndCommands) {
  EXPECT_EQ(played(busy_world(4), 7), played(busy_world(4), 7));
}

TEST(World, IsAnotherForAnotherSeed) {
  EXPECT_NE(played(busy_world(4), 7).digest, played(busy_world(4), 8).digest);
}

TEST(World, IsAnotherForOtherCommands) {
  EXPECT_NE(played(busy_world(4), 7, 1).digest, played(busy_world(4), 7, 2).digest);
}

TEST(World, DoesNotMindTheOrderOfCommands) {
  const WorldConfig config = busy_world(6);
  World straight(config, 7);
  World shuffled(config, 7);
  Stream chance(1, "commands");
  Stream order(1, "order");
  for (Tick tick = 0; tick < kTicks; ++tick) {
    std::vector<Command> commands = random_commands(6, tick, chance);
    straight.step(commands);
    for (std::size_t i = commands.size(); i > 1; --i) {
      std::swap(commands[i - 1], commands[order.below(i)]);
    }
    shuffled.step(commands);
    ASSERT_EQ(straight.digest(), shuffled.digest());
  }
}

TEST(World, AccountsForEveryEnemyAtEveryTick) {
  for (std::int64_t strategy = 1; strategy <= 5; ++strategy) {
    WorldConfig config = busy_world(4);
    config.enemies.strategy = strategy;
    World world(config, 7);
    Stream chance(1, "commands");
    WorldView view;
    std::ptrdiff_t balance = 0;
    std::ptrdiff_t ended = 0;
    for (Tick tick = 0; tick < kTicks; ++tick) {
      const auto events = world.step(random_commands(4, tick, chance));
      const auto gone = count_of<EnemyIntercepted>(events) + count_of<TargetHit>(events);
      balance += count_of<EnemyCreated>(events) - gone;
      ended += gone;
      world.view(view);
      ASSERT_EQ(balance, static_cast<std::ptrdiff_t>(view.enemies.size()));
    }
    EXPECT_GT(ended, 0) << strategy;
  }
}

TEST(World, NumbersEnemiesFromOneInOrderAndNeverAgain) {
  std::uint32_t last = 0;
  for (const Event& event : played(busy_world(4), 7).events) {
    if (const auto* created = std::get_if<EnemyCreated>(&event.what)) {
      ASSERT_EQ(created->enemy.value, ++last);
    }
  }
  EXPECT_GT(last, 20u);
}

TEST(World, EndsEachEnemyOnceAndOnlyAfterItsCreation) {
  std::set<EnemyId> alive;
  for (const Event& event : played(busy_world(4), 7).events) {
    if (const auto* created = std::get_if<EnemyCreated>(&event.what)) {
      alive.insert(created->enemy);
    } else if (const auto* shot = std::get_if<EnemyIntercepted>(&event.what)) {
      ASSERT_EQ(alive.erase(shot->enemy), 1u);
    } else if (const auto* hit = std::get_if<TargetHit>(&event.what)) {
      ASSERT_EQ(alive.erase(hit->enemy), 1u);
    }
  }
}

TEST(World, TellsEventsInOrderOfTime) {
  const std::vector<Event> events = played(busy_world(4), 7).events;
  EXPECT_TRUE(std::is_sorted(events.begin(), events.end(),
                             [](const Event& a, const Event& b) { return a.tick < b.tick; }));
}

TEST(World, PutsACheckpointEverySoManyTicks) {
  WorldConfig config = busy_world(3);
  config.physics.checkpoint_ticks = 50;
  World world(config, 7);
  for (Tick tick = 1; tick <= 200; ++tick) {
    const auto events = world.step({});
    const bool last_is_checkpoint =
        !events.empty() && std::holds_alternative<Checkpoint>(events.back().what);
    ASSERT_EQ(last_is_checkpoint, tick % 50 == 0);
    ASSERT_EQ(count_of<Checkpoint>(events), static_cast<std::ptrdiff_t>(last_is_checkpoint));
  }
}

TEST(World, PutsItsDigestAndTheTeamsMeansIntoACheckpoint) {
  WorldConfig config = busy_world(3);
  config.physics.checkpoint_ticks = 40;
  World world(config, 7);
  Stream chance(1, "commands");
  Event last;
  for (Tick tick = 0; tick < 40; ++tick) {
    for (const Event& event : world.step(random_commands(3, tick, chance))) {
      last = event;
    }
  }
  const auto& checkpoint = std::get<Checkpoint>(last.what);
  WorldView view;
  world.view(view);
  double distance = 0.0;
  double speed = 0.0;
  for (const ViewedRobot& robot : view.robots) {
    distance += (robot.pose.position_m - WorldVec{30.0, 30.0}).norm() / 3.0;
    speed += robot.velocity_mps.norm() / 3.0;
  }
  EXPECT_EQ(last.tick, world.tick());
  EXPECT_EQ(checkpoint.state_digest, world.digest());
  EXPECT_EQ(checkpoint.enemies, view.enemies.size());
  EXPECT_NEAR(checkpoint.mean_distance_to_target_m, distance, 1e-12);
  EXPECT_NEAR(checkpoint.mean_speed_mps, speed, 1e-12);
}

TEST(World, KeepsWorkingWhenMoved) {
  const WorldConfig config = busy_world(4);
  World whole(config, 7);
  World first(config, 7);
  Stream chance(1, "commands");
  Stream same(1, "commands");
  for (Tick tick = 0; tick < 200; ++tick) {
    whole.step(random_commands(4, tick, chance));
    first.step(random_commands(4, tick, same));
  }
  World second = std::move(first);
  for (Tick tick = 200; tick < 400; ++tick) {
    whole.step(random_commands(4, tick, chance));
    second.step(random_commands(4, tick, same));
  }
  EXPECT_EQ(second.digest(), whole.digest());
  EXPECT_EQ(second.tick(), 400u);
}

TEST(World, ReadsAloneDoNotChangeIt) {
  const WorldConfig config = busy_world(4);
  World watched(config, 7);
  World alone(config, 7);
  WorldView view;
  for (Tick tick = 0; tick < 200; ++tick) {
    watched.view(view);
    static_cast<void>(watched.percepts());
    static_cast<void>(watched.digest());
    watched.step({});
    alone.step({});
  }
  EXPECT_EQ(watched.digest(), alone.digest());
}

TEST(World, DoesNotChangeWithTheRobotsSensors) {
  const WorldConfig exact = busy_world(4);
  WorldConfig noisy = exact;
  noisy.sight.range_noise_m = 1.0;
  noisy.sight.bearing_noise_deg = 5.0;
  EXPECT_EQ(played(noisy, 7), played(exact, 7));
}

TEST(World, NeverHoldsMoreEnemiesThanTheLimit) {
  WorldConfig config = busy_world(1);
  config.enemies.strategy = 1;
  config.enemies.max_alive = 3;
  World world(config, 7);
  WorldView view;
  std::size_t most = 0;
  for (Tick tick = 0; tick < kTicks; ++tick) {
    world.step({});
    world.view(view);
    most = std::max(most, view.enemies.size());
  }
  EXPECT_EQ(most, 3u);
}

TEST(World, CountsTicksAndSimulatedTime) {
  World world(busy_world(2), 7);
  EXPECT_EQ(world.tick(), 0u);
  for (Tick tick = 0; tick < 25; ++tick) {
    world.step({});
  }
  WorldView view;
  world.view(view);
  EXPECT_EQ(world.tick(), 25u);
  EXPECT_EQ(view.tick, 25u);
  EXPECT_NEAR(view.time_s, 2.5, 1e-12);
  for (const Percept& percept : world.percepts()) {
    EXPECT_EQ(percept.tick, 25u);
  }
}

TEST(World, OrdersPerceptsByRobot) {
  const World world(busy_world(5), 7);
  ASSERT_EQ(world.percepts().size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(world.percepts()[i].robot.value, i + 1);
  }
}

template <class Member>
constexpr bool kIsIdentity = std::is_same_v<std::remove_cvref_t<Member>, RobotId> ||
                             std::is_same_v<std::remove_cvref_t<Member>, EnemyId> ||
                             (std::is_integral_v<std::remove_cvref_t<Member>> &&
                              !std::is_same_v<std::remove_cvref_t<Member>, bool>);

// The bindings name every member: one more, and this must be thought over.
TEST(Percepts, CarryNoIdentityOfOthers) {
  const Sighting sighting;
  const auto& [kind, colour, offset, radius] = sighting;
  static_assert(!kIsIdentity<decltype(kind)> && !kIsIdentity<decltype(colour)> &&
                !kIsIdentity<decltype(offset)> && !kIsIdentity<decltype(radius)>);
  const SeenObstacle seen;
  const auto& [place, extent] = seen;
  static_assert(!kIsIdentity<decltype(place)> && !kIsIdentity<decltype(extent)>);
  const Percept percept;
  const auto& [robot, tick, odometry, velocity, touching, able, holding, held, deeds, sightings,
               obstacles, site, hallway, doorways, heard, operated] = percept;
  const auto& [picked_up, stored, dropped, intercepted, revived, marked, signalled, alerted,
               tested] = deeds;
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(picked_up)>, bool>);
  EXPECT_FALSE(picked_up || stored || dropped || intercepted || revived || marked || signalled ||
               alerted || tested != Finding::None);
  EXPECT_EQ(robot, RobotId{});
  EXPECT_EQ(tick, 0u);
  EXPECT_TRUE(sightings.empty() && obstacles.empty() && !touching && able && !holding);
  EXPECT_TRUE(site == Site::Open && !hallway && doorways.empty() && heard.empty() &&
              held == Colour::Orange && !operated.teleoperated);
  EXPECT_EQ(velocity, BodyVec{});
  EXPECT_EQ(odometry.position_m, OdometryVec{});
}

TEST(Percepts, CarryNoNumberOfARoomOrDoorway) {
  const SeenDoorway doorway;
  const auto& [middle, jamb, is_marked] = doorway;
  static_assert(!kIsIdentity<decltype(middle)> && !kIsIdentity<decltype(jamb)> &&
                !kIsIdentity<decltype(is_marked)>);
  const SeenHallway hallway;
  const auto& [nearest, along, ahead, behind, width] = hallway;
  static_assert(!kIsIdentity<decltype(nearest)> && !kIsIdentity<decltype(along)> &&
                !kIsIdentity<decltype(ahead)> && !kIsIdentity<decltype(behind)> &&
                !kIsIdentity<decltype(width)>);
  EXPECT_FALSE(is_marked);
  EXPECT_EQ(width, 0.0);
}

}  // namespace
}  // namespace tacit
