#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tests/world/forage_field.h"

namespace tacit {
namespace {

constexpr Tick kTicks = 1500;

struct History {
  std::uint64_t digest = 0;
  std::vector<Event> events;
  friend bool operator==(const History&, const History&) = default;
};

History played(const WorldConfig& config, std::uint64_t seed) {
  Field field(config, seed);
  Stream chance(seed, "commands");
  History history;
  while (!field.world.over() && field.world.tick() < kTicks) {
    field.step(random_deeds(config.robots.count, chance));
    history.events.insert(history.events.end(), field.told.begin(), field.told.end());
  }
  history.digest = field.world.digest();
  return history;
}

TEST(ForageWorld, IsTheSameForTheSameSeedAndCommands) {
  EXPECT_EQ(played(wild_field(5), 7), played(wild_field(5), 7));
  EXPECT_NE(played(wild_field(5), 7).digest, played(wild_field(5), 8).digest);
}

TEST(ForageWorld, DoesNotMindTheOrderOfCommands) {
  Field straight(wild_field(5), 7);
  Field shuffled(wild_field(5), 7);
  Stream chance(1, "commands");
  Stream order(1, "order");
  while (!straight.world.over() && straight.world.tick() < kTicks) {
    std::vector<Command> commands = random_deeds(5, chance);
    straight.step(commands);
    for (std::size_t i = commands.size(); i > 1; --i) {
      std::swap(commands[i - 1], commands[order.below(i)]);
    }
    shuffled.step(commands);
    ASSERT_EQ(straight.told, shuffled.told);
    ASSERT_EQ(straight.world.digest(), shuffled.world.digest());
  }
}

// What a stranger who only hears the events knows of the mines.
struct Ledger {
  std::set<std::uint32_t> lying;
  std::set<std::pair<std::uint16_t, std::uint32_t>> held;
  std::size_t stored = 0;

  void hear(const Event& event) {
    if (const auto* taken = std::get_if<MineTaken>(&event.what)) {
      EXPECT_EQ(lying.erase(taken->mine.value), 1u);
      held.insert({taken->robot.value, taken->mine.value});
    } else if (const auto* dropped = std::get_if<MineDropped>(&event.what)) {
      EXPECT_EQ(held.erase({dropped->robot.value, dropped->mine.value}), 1u);
      lying.insert(dropped->mine.value);
    } else if (const auto* put = std::get_if<MineStored>(&event.what)) {
      EXPECT_EQ(held.erase({put->robot.value, put->mine.value}), 1u);
      ++stored;
      EXPECT_EQ(put->left, lying.size() + held.size());
    }
  }
};

TEST(ForageWorld, KeepsEveryMineAtEveryTick) {
  std::size_t stored = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Field field(wild_field(5), seed);
    Stream chance(seed, "commands");
    Ledger ledger;
    for (const ViewedMine& mine : field.view.mines) {
      ledger.lying.insert(mine.mine.value);
    }
    ASSERT_EQ(ledger.lying.size(), 6u);
    while (!field.world.over() && field.world.tick() < kTicks) {
      field.step(random_deeds(5, chance));
      std::for_each(field.told.begin(), field.told.end(), [&](const Event& e) { ledger.hear(e); });
      ASSERT_EQ(ledger.lying.size(), field.view.mines.size());
      const auto held = std::count_if(field.view.robots.begin(), field.view.robots.end(),
                                      [](const ViewedRobot& r) { return r.holding; });
      ASSERT_EQ(ledger.held.size(), static_cast<std::size_t>(held));
      ASSERT_EQ(ledger.lying.size() + ledger.held.size() + ledger.stored, 6u);
    }
    stored += ledger.stored;
  }
  EXPECT_GT(stored, 10u);
}

TEST(ForageWorld, MovesNoDisabledRobot) {
  int still = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Field field(wild_field(5), seed);
    Stream chance(seed, "commands");
    while (!field.world.over() && field.world.tick() < kTicks) {
      field.step(random_deeds(5, chance));
      for (std::size_t i = 0; i < 5; ++i) {
        if (!field.before.robots[i].able) {
          ASSERT_EQ(field.before.robots[i].pose.position_m, field.view.robots[i].pose.position_m);
          ++still;
        }
      }
    }
  }
  EXPECT_GT(still, 1000);
}

TEST(ForageWorld, KeepsEverythingInsideTheArea) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Field field(wild_field(5), seed);
    Stream chance(seed, "commands");
    const auto inside = [](const WorldVec& p) {
      return std::min({p.x(), p.y(), 20.0 - p.x(), 20.0 - p.y()}) > 0.0;
    };
    while (!field.world.over() && field.world.tick() < kTicks) {
      field.step(random_deeds(5, chance));
      for (const ViewedRobot& robot : field.view.robots) {
        ASSERT_TRUE(inside(robot.pose.position_m));
      }
      for (const ViewedEnemy& hunter : field.view.enemies) {
        ASSERT_TRUE(inside(hunter.position_m));
      }
      for (const ViewedMine& mine : field.view.mines) {
        ASSERT_TRUE(inside(mine.position_m));
      }
    }
  }
}

TEST(ForageWorld, FeelsWhatItShows) {
  Field field(wild_field(5), 3);
  Stream chance(3, "commands");
  while (!field.world.over() && field.world.tick() < kTicks) {
    field.step(random_deeds(5, chance));
    for (std::size_t i = 0; i < 5; ++i) {
      ASSERT_EQ(field.world.percepts()[i].able, field.view.robots[i].able);
      ASSERT_EQ(field.world.percepts()[i].holding, field.view.robots[i].holding);
      ASSERT_FALSE(field.view.robots[i].holding && !field.view.robots[i].able);
    }
  }
}

TEST(ForageWorld, EndsEveryHunterOnceAndOnlyAfterItsCreation) {
  std::size_t ended = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::set<EnemyId> outside;
    std::uint32_t last = 0;
    for (const Event& event : played(wild_field(5), seed).events) {
      if (const auto* created = std::get_if<EnemyCreated>(&event.what)) {
        ASSERT_EQ(created->enemy.value, ++last);
        outside.insert(created->enemy);
      } else if (const auto* shot = std::get_if<EnemyIntercepted>(&event.what)) {
        ASSERT_EQ(outside.erase(shot->enemy), 1u);
        ++ended;
      } else if (const auto* back = std::get_if<EnemyRetreated>(&event.what)) {
        ASSERT_EQ(outside.erase(back->enemy), 1u);
        ++ended;
      }
    }
  }
  EXPECT_GT(ended, 10u);
}

TEST(ForageWorld, EndsWithItsVerdictAndTellsItOnce) {
  std::set<Verdict> verdicts;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    WorldConfig config = wild_field(3);
    config.forage.cap_ticks = 800;
    const std::vector<Event> events = played(config, seed).events;
    const auto verdict = [](const Event& e) { return std::holds_alternative<MissionOver>(e.what); };
    ASSERT_EQ(std::count_if(events.begin(), events.end(), verdict), 1);
    ASSERT_TRUE(verdict(events.back()));
    verdicts.insert(std::get<MissionOver>(events.back().what).verdict);
  }
  EXPECT_GE(verdicts.size(), 2u);
}

TEST(World, TellsAnObserverItsPhasesInOrder) {
  World world(busy_world(2), 1);
  std::vector<WorldPhase> phases;
  world.on_phase([&phases](WorldPhase phase) { phases.push_back(phase); });
  world.step({});
  EXPECT_EQ(phases, (std::vector<WorldPhase>{WorldPhase::Intent, WorldPhase::Motion,
                                             WorldPhase::Rules, WorldPhase::Sensing}));
  world.on_phase({});
  world.step({});
  EXPECT_EQ(phases.size(), 4u);
}

}  // namespace
}  // namespace tacit
