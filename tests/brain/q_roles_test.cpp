#include "robot_agent/brain/learning/q_roles.h"

#include <gtest/gtest.h>

#include <numeric>

#include "robot_agent/brain/learning/policy_table.h"
#include "tests/brain/forage_surroundings.h"

namespace tacit {
namespace {

using testing::disabled;
using testing::enemy;
using testing::mine;

QRoles::Config greedy() {
  QRoles::Config config;
  config.learner.epsilon = 0.0;
  return config;
}

/// A learner of which each role's worth, whatever the state, is given; it lives tick by tick.
class Robot {
 public:
  Robot(const QRoles::Config& config, const std::array<double, kRoles>& worth)
      : roles_(config, Self{RobotId{3}, 1}) {
    std::vector<double> q;
    for (std::size_t state = 0; state < kInternalStates; ++state) {
      q.insert(q.end(), worth.begin(), worth.end());
    }
    inherit(q);
  }
  void inherit(const std::vector<double>& q) {
    PolicyTable policy = parse_policy(roles_.policy(), "own");
    policy.table.q = q;
    roles_.inherit(to_text(policy), "own");
  }

  Role live(std::vector<Sighting> sightings, Deeds deeds = {}, bool revived = false) {
    Percept percept = testing::percept(tick_, std::move(sightings));
    percept.deeds = deeds;
    const Surroundings& around = perception_.look(percept);
    ++tick_;
    return roles_.choose({around, role_triggers(around, {}), revived});
  }
  void live_quietly(int ticks) {
    for (int i = 0; i < ticks; ++i) static_cast<void>(live({}));
  }

  [[nodiscard]] QTable table() const { return parse_policy(roles_.policy(), "own").table; }
  [[nodiscard]] std::uint64_t queries() const {
    const QTable now = table();
    return std::accumulate(now.visits.begin(), now.visits.end(), std::uint64_t{0});
  }
  [[nodiscard]] double q(TriggerSet triggers, Role played, Role chosen) const {
    return table().row(internal_state(triggers, played))[index(chosen)];
  }
  [[nodiscard]] const QRoles& roles() const { return roles_; }

 private:
  QRoles roles_;
  ForagePerception perception_{1.2, BrainConfig{}.pursuit};
  Tick tick_ = 0;
};

constexpr std::array<double, kRoles> kForagersWorld{2.0, 1.0, 1.5};
constexpr std::array<double, kRoles> kSoldiersWorld{1.0, 2.0, 1.5};
constexpr std::array<double, kRoles> kMechanicsWorld{1.0, 1.5, 2.0};
constexpr double kAlpha = 0.09;  // After one decay.

TEST(QRoles, QueryInTheFirstTickAsAForager) {
  Robot robot(greedy(), kSoldiersWorld);
  EXPECT_EQ(robot.live({}), Role::Soldier);
  EXPECT_EQ(robot.queries(), 1U);
  EXPECT_EQ(robot.table().visits[internal_state({}, Role::Forager) * kRoles + 1], 1U);
}

TEST(QRoles, StayWhileNothingHappens) {
  Robot robot(greedy(), kSoldiersWorld);
  robot.live_quietly(300);
  EXPECT_EQ(robot.queries(), 1U);
}

TEST(QRoles, QueryWhenTheTriggersChange) {
  Robot robot(greedy(), kForagersWorld);
  robot.live_quietly(5);
  static_cast<void>(robot.live({enemy(30, 0)}));
  EXPECT_EQ(robot.queries(), 2U);
  static_cast<void>(robot.live({enemy(29, 0)}));
  EXPECT_EQ(robot.queries(), 2U);
  static_cast<void>(robot.live({enemy(4, 0)}));
  EXPECT_EQ(robot.queries(), 3U);
  static_cast<void>(robot.live({}));
  EXPECT_EQ(robot.queries(), 4U);
  EXPECT_EQ(robot.table().visits[internal_state({1}, Role::Forager) * kRoles], 1U);
  EXPECT_EQ(robot.table().visits[internal_state({3}, Role::Forager) * kRoles], 1U);
}

TEST(QRoles, QueryWhenARoleWasPlayedForLong) {
  Robot robot(greedy(), kForagersWorld);
  robot.live_quietly(300);
  EXPECT_EQ(robot.queries(), 1U);
  robot.live_quietly(1);
  EXPECT_EQ(robot.queries(), 2U);
}

TEST(QRoles, CountTheTimeOutFromTheLastQuery) {
  Robot robot(greedy(), kForagersWorld);
  robot.live_quietly(200);
  static_cast<void>(robot.live({enemy(30, 0)}));
  static_cast<void>(robot.live({}));
  robot.live_quietly(299);
  EXPECT_EQ(robot.queries(), 3U);
  robot.live_quietly(1);
  EXPECT_EQ(robot.queries(), 4U);
}

TEST(QRoles, CreditAMineStored) {
  Robot robot(greedy(), kForagersWorld);
  robot.live_quietly(1);
  static_cast<void>(robot.live({}, {.stored = true}));
  EXPECT_EQ(robot.queries(), 2U);
  EXPECT_DOUBLE_EQ(robot.q({}, Role::Forager, Role::Forager),
                   2.0 + kAlpha * (20.0 + 0.8 * 2.0 - 2.0));
}

TEST(QRoles, QueryOnceForAChangeThatComesWithAReward) {
  Robot robot(greedy(), kForagersWorld);
  robot.live_quietly(1);
  static_cast<void>(robot.live({enemy(30, 0)}, {.stored = true}));
  EXPECT_EQ(robot.queries(), 2U);
  static_cast<void>(robot.live({enemy(30, 0)}));
  EXPECT_EQ(robot.queries(), 2U);
}

TEST(QRoles, CreditAidToAMechanicAlone) {
  Robot mechanic(greedy(), kMechanicsWorld);
  mechanic.live_quietly(1);
  mechanic.live_quietly(1);
  static_cast<void>(mechanic.live({}, {.revived = true}));
  EXPECT_DOUBLE_EQ(mechanic.q({}, Role::Forager, Role::Mechanic),
                   2.0 + kAlpha * (10.0 + 0.8 * 2.0 - 2.0));
  Robot forager(greedy(), kForagersWorld);
  forager.live_quietly(2);
  static_cast<void>(forager.live({}, {.revived = true}));
  EXPECT_EQ(forager.queries(), 1U);
}

TEST(QRoles, CreditInterceptionToASoldierAlone) {
  QRoles::Config config = greedy();
  config.rewards.intercept = 5.0;
  Robot soldier(config, kSoldiersWorld);
  soldier.live_quietly(2);
  static_cast<void>(soldier.live({}, {.intercepted = true}));
  EXPECT_DOUBLE_EQ(soldier.q({}, Role::Forager, Role::Soldier),
                   2.0 + kAlpha * (5.0 + 0.8 * 2.0 - 2.0));
  Robot forager(config, kForagersWorld);
  forager.live_quietly(2);
  static_cast<void>(forager.live({}, {.intercepted = true}));
  EXPECT_EQ(forager.queries(), 1U);
}

TEST(QRoles, DoNotQueryForARewardOfZero) {
  Robot soldier(greedy(), kSoldiersWorld);
  soldier.live_quietly(2);
  static_cast<void>(soldier.live({}, {.intercepted = true}));
  EXPECT_EQ(soldier.queries(), 1U);
}

TEST(QRoles, QueryOncePerDeedThatIsWorthSomething) {
  Robot mechanic(greedy(), kMechanicsWorld);
  mechanic.live_quietly(2);
  static_cast<void>(mechanic.live({}, {.stored = true, .revived = true}));
  EXPECT_EQ(mechanic.queries(), 3U);
  // The first goes to what was chosen as a Forager, the second to what the first query chose.
  EXPECT_DOUBLE_EQ(mechanic.q({}, Role::Forager, Role::Mechanic),
                   2.0 + kAlpha * (20.0 + 0.8 * 2.0 - 2.0));
  EXPECT_DOUBLE_EQ(mechanic.q({}, Role::Mechanic, Role::Mechanic),
                   2.0 + kAlpha * (10.0 + 0.8 * 2.0 - 2.0));
}

TEST(QRoles, QueryForAllDeedsOfATickFromTheStateThatItFound) {
  Robot robot(greedy(), kMechanicsWorld);
  std::vector<double> q = robot.table().q;
  const std::size_t as_mechanic = internal_state({}, Role::Mechanic) * kRoles;
  q[as_mechanic + index(Role::Forager)] = 50.0;
  robot.inherit(q);
  EXPECT_EQ(robot.live({}), Role::Mechanic);
  EXPECT_EQ(robot.live({}, {.stored = true, .revived = true}), Role::Forager);
  EXPECT_EQ(robot.table().visits[as_mechanic + index(Role::Forager)], 2U);
}

TEST(QRoles, QueryOnceOnRevivalWhateverElseHappened) {
  Robot robot(greedy(), kForagersWorld);
  robot.live_quietly(2);
  static_cast<void>(robot.live({}, {.stored = true}, true));
  EXPECT_EQ(robot.queries(), 2U);
  EXPECT_DOUBLE_EQ(robot.q({}, Role::Forager, Role::Forager), 2.0 + kAlpha * (0.8 * 2.0 - 2.0));
}

TEST(QRoles, CountTheirUpdatesAsLessons) {
  Robot robot(greedy(), kForagersWorld);
  robot.live_quietly(1);
  EXPECT_EQ(robot.roles().lessons(), 0U);
  static_cast<void>(robot.live({enemy(30, 0)}));
  EXPECT_EQ(robot.roles().lessons(), 1U);
}

TEST(QRoles, OfTwoRobotsBeginWithDifferentTables) {
  const QRoles one({}, Self{RobotId{1}, 7});
  const QRoles two({}, Self{RobotId{2}, 7});
  EXPECT_NE(parse_policy(one.policy(), "one").table.q, parse_policy(two.policy(), "two").table.q);
}

}  // namespace
}  // namespace tacit
