#include "console/metrics/forage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "console/metrics/tally.h"

namespace tacit {
namespace {

Forage folded(std::initializer_list<Happening> happenings) {
  Forage forage;
  for (const Happening& what : happenings) {
    forage.add({7, what});
  }
  return forage;
}

std::optional<double> value(const Tally& tally, std::string_view key) { return tally.value(key); }

Tally tally_of(std::initializer_list<Happening> happenings) {
  Tally tally;
  for (const Happening& what : happenings) {
    tally.add({7, what});
  }
  return tally;
}

TEST(Forage, CountsMinesStoredAndLeft) {
  const Forage forage = folded({ForageBegun{3}, MineTaken{{1}, {2}}, MineStored{{1}, {2}, 2}});
  EXPECT_EQ(forage.stored, 1U);
  EXPECT_EQ(forage.mines_left(), 2U);
}

TEST(Forage, TellsTerrainFromHunters) {
  const Forage forage = folded({RobotDisabled{{1}, Mishap::Mud}, RobotDisabled{{2}, Mishap::Enemy},
                                RobotDisabled{{3}, Mishap::Enemy}, RobotRevived{{1}, {4}}});
  EXPECT_EQ(forage.stuck, 1U);
  EXPECT_EQ(forage.struck, 2U);
  EXPECT_EQ(forage.disabled(), 2U);
}

TEST(Forage, CountsHuntersOnly) {
  const Forage forage =
      folded({EnemyCreated{{1}, EnemyKind::Hunter, {}}, EnemyCreated{{2}, EnemyKind::Normal, {}},
              EnemyIntercepted{{1}, EnemyKind::Hunter, {1}, 0.0},
              EnemyIntercepted{{2}, EnemyKind::Decoy, {1}, 0.0}});
  EXPECT_EQ(forage.hunters, 1U);
  EXPECT_EQ(forage.intercepted, 1U);
}

TEST(Forage, HasTheMissionsScore) {
  const Tally tally = tally_of({ForageBegun{3}, MissionOver{Verdict::Accomplished, 1234}});
  EXPECT_EQ(value(tally, "score_ticks"), 1234.0);
  EXPECT_EQ(value(tally, "failed"), 0.0);
}

TEST(Forage, MarksALostTeamAsFailed) {
  const Tally tally = tally_of({ForageBegun{3}, MissionOver{Verdict::TeamLost, 1000000}});
  EXPECT_EQ(value(tally, "score_ticks"), 1e6);
  EXPECT_EQ(value(tally, "failed"), 1.0);
}

TEST(Forage, HasNoScoreWhileTheMissionLasts) {
  EXPECT_EQ(value(tally_of({ForageBegun{3}}), "score_ticks"), std::nullopt);
}

TEST(Tally, OfAForageRunLeavesOutWhatOnlyAGuardHas) {
  EXPECT_EQ(value(tally_of({ForageBegun{3}}), "successful"), std::nullopt);
  EXPECT_EQ(value(tally_of({ForageBegun{3}}), "collisions"), 0.0);
}

TEST(Tally, OfAGuardLeavesOutWhatOnlyForagersHave) {
  EXPECT_EQ(value(tally_of({}), "mines_stored"), std::nullopt);
  EXPECT_EQ(value(tally_of({}), "successful"), 0.0);
}

}  // namespace
}  // namespace tacit
