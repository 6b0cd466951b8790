#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "robot_agent/brain/fsa/automaton.h"
#include "robot_agent/brain/roles/registry.h"
#include "tests/brain/forage_surroundings.h"

namespace tacit {
namespace {

using testing::base;
using testing::disabled;
using testing::enemy;
using testing::ForageEyes;
using testing::holding;
using testing::mine;
using testing::percept;
using testing::teammate;

Automaton automaton(Role role) {
  const BrainConfig config = brain_defaults(MissionKind::Forage);
  return {kRolePlans[index(role)](config.roles), config.schemas, Self{RobotId{1}, 1}};
}

/// Where `role` goes from `state` when it perceives `now`.
std::string next(Role role, std::string_view state, const Percept& now) {
  Automaton played = automaton(role);
  ForageEyes eyes;
  played.resume(state, {0, {}});
  static_cast<void>(played.step(eyes.look(now)));
  return std::string(played.state());
}

/// What `role` does in `state` when it perceives `now`.
Doing doing(Role role, std::string_view state, const Percept& now) {
  Automaton played = automaton(role);
  ForageEyes eyes;
  played.resume(state, {0, {}});
  const Doing doing = played.step(eyes.look(now));
  EXPECT_EQ(played.state(), state);
  return doing;
}

struct Transition {
  const char* name;
  Role role;
  const char* state;
  Percept now;
  const char* next;
};

class Transitions : public ::testing::TestWithParam<Transition> {};

TEST_P(Transitions, AreMade) {
  const Transition& each = GetParam();
  EXPECT_EQ(next(each.role, each.state, each.now), each.next);
}

Percept seeing(std::vector<Sighting> sightings) { return percept(0, std::move(sightings)); }

INSTANTIATE_TEST_SUITE_P(
    OfTheForager, Transitions,
    ::testing::Values(
        Transition{"SeesNone", Role::Forager, "LookForMine", seeing({base(1, 0)}), "LookForMine"},
        Transition{"SeesAMine", Role::Forager, "LookForMine", seeing({mine(9, 0)}), "MoveToMine"},
        Transition{"HoldsOneAlready", Role::Forager, "LookForMine", holding({mine(9, 0)}),
                   "MoveToBase"},
        Transition{"IsFar", Role::Forager, "MoveToMine", seeing({mine(0.46, 0)}), "MoveToMine"},
        Transition{"IsNear", Role::Forager, "MoveToMine", seeing({mine(0.44, 0)}), "PickUp"},
        Transition{"LosesIt", Role::Forager, "MoveToMine", seeing({}), "LookForMine"},
        Transition{"HoldsOneOnTheWay", Role::Forager, "MoveToMine", holding({mine(9, 0)}),
                   "MoveToBase"},
        Transition{"StillPicksUp", Role::Forager, "PickUp", seeing({mine(0.49, 0)}), "PickUp"},
        Transition{"HasPickedUp", Role::Forager, "PickUp", holding({}), "MoveToBase"},
        Transition{"IsTooLate", Role::Forager, "PickUp", seeing({}), "LookForMine"},
        Transition{"HasDriftedOff", Role::Forager, "PickUp", seeing({mine(0.51, 0)}),
                   "LookForMine"},
        Transition{"IsFarFromBase", Role::Forager, "MoveToBase", holding({base(0.81, 0)}),
                   "MoveToBase"},
        Transition{"IsNearBase", Role::Forager, "MoveToBase", holding({base(0.79, 0)}), "Drop"},
        Transition{"HasLostTheMine", Role::Forager, "MoveToBase", seeing({base(9, 0)}),
                   "LookForMine"},
        Transition{"NeverSawTheBase", Role::Forager, "MoveToBase", holding({}), "LookForBase"},
        Transition{"StillLooksForTheBase", Role::Forager, "LookForBase", holding({mine(1, 0)}),
                   "LookForBase"},
        Transition{"FindsTheBase", Role::Forager, "LookForBase", holding({base(9, 0)}),
                   "MoveToBase"},
        Transition{"LosesTheMineLooking", Role::Forager, "LookForBase", seeing({}), "LookForMine"},
        Transition{"StillDrops", Role::Forager, "Drop", holding({base(0.99, 0)}), "Drop"},
        Transition{"HasDropped", Role::Forager, "Drop", seeing({base(0.7, 0)}), "LookForMine"},
        Transition{"HasDriftedOffBase", Role::Forager, "Drop", holding({base(1.01, 0)}),
                   "MoveToBase"}),
    [](const auto& each) { return std::string(each.param.name); });

INSTANTIATE_TEST_SUITE_P(
    OfTheSoldier, Transitions,
    ::testing::Values(
        Transition{"SeesNone", Role::Soldier, "Patrol", seeing({mine(1, 0)}), "Patrol"},
        Transition{"SeesAnEnemy", Role::Soldier, "Patrol", seeing({enemy(40, 0)}), "Intercept"},
        Transition{"StaysOnIt", Role::Soldier, "Intercept", seeing({enemy(40, 0)}), "Intercept"},
        Transition{"LosesIt", Role::Soldier, "Intercept", seeing({}), "Patrol"}),
    [](const auto& each) { return std::string(each.param.name); });

INSTANTIATE_TEST_SUITE_P(
    OfTheMechanic, Transitions,
    ::testing::Values(
        Transition{"SeesNone", Role::Mechanic, "Search", seeing({teammate(1, 0)}), "Search"},
        Transition{"SeesOne", Role::Mechanic, "Search", seeing({disabled(40, 0)}),
                   "MoveToDisabled"},
        Transition{"IsFar", Role::Mechanic, "MoveToDisabled", seeing({disabled(1.01, 0)}),
                   "MoveToDisabled"},
        Transition{"IsNear", Role::Mechanic, "MoveToDisabled", seeing({disabled(0.99, 0)}), "Aid"},
        Transition{"OthersAreFaster", Role::Mechanic, "MoveToDisabled", seeing({teammate(9, 0)}),
                   "Search"},
        Transition{"StillAids", Role::Mechanic, "Aid", seeing({disabled(0.4, 0)}), "Aid"},
        Transition{"HasRevivedIt", Role::Mechanic, "Aid", seeing({teammate(0.4, 0)}), "Search"},
        Transition{"GoesOnToTheNext", Role::Mechanic, "Aid",
                   seeing({teammate(0.4, 0), disabled(9, 0)}), "MoveToDisabled"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(Forager, MovesToTheMineThenStandsAndTakesItUp) {
  const Doing moving = doing(Role::Forager, "MoveToMine", seeing({mine(9, 0)}));
  EXPECT_GT(moving.sum.x(), 0.8);
  EXPECT_EQ(moving.act, Act::None);
  const Doing standing = doing(Role::Forager, "PickUp", seeing({mine(0.4, 0)}));
  EXPECT_EQ(standing.sum, BodyVec());
  EXPECT_EQ(standing.act, Act::PickUp);
}

TEST(Forager, MovesToTheBaseThenStandsAndDrops) {
  const Doing moving = doing(Role::Forager, "MoveToBase", holding({base(9, 0)}));
  EXPECT_GT(moving.sum.x(), 0.8);
  EXPECT_EQ(moving.act, Act::None);
  const Doing standing = doing(Role::Forager, "Drop", holding({base(0.4, 0)}));
  EXPECT_EQ(standing.sum, BodyVec());
  EXPECT_EQ(standing.act, Act::Drop);
}

TEST(Soldier, PursuesWithTwiceTheBaseSpeedReadyToDestroy) {
  const Doing hunting = doing(Role::Soldier, "Intercept", seeing({enemy(0, 9)}));
  EXPECT_EQ(hunting.sum, BodyVec(0, 2));
  EXPECT_EQ(hunting.act, Act::Intercept);
}

TEST(Mechanic, KeepsAidingWhileItMovesOnUntilItTouches) {
  const Doing aiding = doing(Role::Mechanic, "Aid", seeing({disabled(0.41, 0)}));
  EXPECT_GT(aiding.sum.x(), 0.8);
  EXPECT_EQ(aiding.act, Act::Aid);
}

TEST(Roles, WanderWithEightTenthsOfTheBaseSpeedWhileTheySearch) {
  for (const auto& [role, state] : {std::pair{Role::Forager, "LookForMine"},
                                    {Role::Soldier, "Patrol"},
                                    {Role::Mechanic, "Search"}}) {
    const Doing searching = doing(role, state, seeing({}));
    EXPECT_NEAR(searching.sum.norm(), 0.8, 1e-12) << state;
    EXPECT_EQ(searching.act, Act::None) << state;
  }
}

TEST(Roles, KeepOffObstaclesAndAbleTeammatesInEveryStateOfMotion) {
  Percept blocked = seeing({mine(9, 0), base(9, 0), enemy(9, 0), disabled(9, 0)});
  Percept crowded = blocked;
  crowded.sightings.push_back(teammate(0.6, 0));
  blocked.obstacles.push_back({{1.0, 0.0}, 0.5});
  for (const auto& [role, state] : {std::pair{Role::Forager, "MoveToMine"},
                                    {Role::Soldier, "Intercept"},
                                    {Role::Mechanic, "MoveToDisabled"}}) {
    Percept open = blocked;
    open.obstacles.clear();
    const double free_x = doing(role, state, open).sum.x();
    EXPECT_LT(doing(role, state, blocked).sum.x(), free_x) << state;
    EXPECT_LT(doing(role, state, crowded).sum.x(), free_x) << state;
  }
}

TEST(RolesConfig, IsRefusedWhenNearLiesBeyondReach) {
  RolesConfig config;
  config.near_mine_m = 0.6;
  try {
    check(config);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "brain.roles.near_mine_m is 0.6 m, wanted at most brain.roles.pick_up_reach_m, "
                 "which is 0.5 m");
  }
}

}  // namespace
}  // namespace tacit
