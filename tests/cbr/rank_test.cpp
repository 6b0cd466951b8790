#include "wizard_service/cbr/rank.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/cbr/libraries.h"

namespace tacit::cbr {
namespace {

CaseFeatures biohazard_for(int robots) {
  CaseFeatures features = usual_features(Task::Biohazard);
  features.robots = robots;
  return features;
}

TEST(Rank, OfACaseThatMatchesEverythingIsFiveStars) {
  EXPECT_EQ(rank(query_of(biohazard_for(2)), biohazard_for(2), 0), 5 * kStar);
}

TEST(Rank, OfAQueryThatLeavesEverythingOpenIsFiveStars) {
  EXPECT_EQ(rank({}, biohazard_for(7), 0), 5 * kStar);
}

TEST(Rank, OfANumberOfRobotsThatDiffersByTwoCountsAThirdOfItsWeight) {
  // Weights 1.00 + 0.90 / 3 + 0.90 + 0.80 + 0.70 of 4.30.
  EXPECT_EQ(rank(query_of(biohazard_for(3)), biohazard_for(1), 0), 5 * kStar * 370 / 430);
  EXPECT_EQ(rank(query_of(biohazard_for(1)), biohazard_for(3), 0), 5 * kStar * 370 / 430);
}

TEST(Rank, OfWhatIsLeftOpenCountsNothing) {
  Query query;
  query.task = Task::Biohazard;
  query.environment = Environment::Outdoor;
  // 1.00 of 1.00 + 0.80.
  EXPECT_EQ(rank(query, biohazard_for(1), 0), 5 * kStar * 100 / 180);
}

TEST(Rank, OfACaseThatMatchesNothingIsNoStar) {
  Query query;
  query.task = Task::Waypoints;
  query.handles_enemy = true;
  EXPECT_EQ(rank(query, biohazard_for(1), 0), 0);
}

TEST(Rank, GrowsByWhatUseHasTaught) {
  const Query query = query_of(biohazard_for(2));
  EXPECT_EQ(rank(query, biohazard_for(2), 1000), 6 * kStar);
  EXPECT_EQ(rank(query, biohazard_for(2), -1), 5 * kStar - kStar / 1000);
}

TEST(Rank, TellsCasesThatDifferByOneRobotApartWhateverElseMatches) {
  for (int robots = 2; robots <= kMostPlannedRobots; ++robots) {
    EXPECT_LT(rank(query_of(biohazard_for(1)), biohazard_for(robots), 0),
              rank(query_of(biohazard_for(1)), biohazard_for(robots - 1), 0));
  }
}

TEST(Share, IsWholeForEveryNumberOfRobots) {
  for (std::int64_t apart = 0; apart < kMostPlannedRobots; ++apart) {
    EXPECT_EQ(kShareUnit % (1 + apart), 0) << apart;
  }
}

TEST(Standing, OfACaseWithoutOutcomesIsZero) { EXPECT_EQ(standing({}), 0); }

TEST(Standing, OfASingleGoodRunIsAThirdOfAStar) {
  TrackRecord record;
  take_outcome(record, 1.0);
  EXPECT_EQ(standing(record), 333);
}

TEST(Standing, IsRoundedTowardsZeroBelowItToo) {
  TrackRecord record;
  take_outcome(record, 0.0);
  EXPECT_EQ(standing(record), -333);
}

TEST(Standing, OfHalfGoodOutcomesIsZero) {
  TrackRecord record;
  take_outcome(record, 0.5);
  take_outcome(record, 1.0);
  take_outcome(record, 0.0);
  EXPECT_EQ(standing(record), 0);
  EXPECT_EQ(record.outcomes, 3U);
}

TEST(Standing, StaysWithinAStarHoweverMuchIsKnown) {
  TrackRecord record;
  record.outcomes = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(standing(record), -999);
  record.good_milli = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(standing(record), 999);
}

TEST(Outcome, OutsideItsRangeCountsAsTheNearerEnd) {
  TrackRecord record;
  take_outcome(record, 7.0);
  take_outcome(record, -7.0);
  take_outcome(record, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(record.good_milli, 1000U);
}

TEST(Failures, AreKeptNewestLastAndTheOldestGo) {
  TrackRecord record;
  for (std::size_t i = 1; i <= kFailuresKept + 2; ++i) {
    remember_failure(record, {"failure " + std::to_string(i), "office"});
  }
  ASSERT_EQ(record.failures.size(), kFailuresKept);
  EXPECT_EQ(record.failures.front().what, "failure 3");
  EXPECT_EQ(record.failures.back().what, "failure 7");
}

}  // namespace
}  // namespace tacit::cbr
