#include "wizard_service/cbr/case_index.h"

#include <gtest/gtest.h>

#include "tests/cbr/libraries.h"

namespace tacit::cbr {
namespace {

constexpr std::size_t kAll = 1'000'000;

CaseIndex one_by_one(const std::vector<CaseHead>& library) {
  CaseIndex index;
  for (const CaseHead& head : library) index.insert(head);
  return index;
}

class SizesOfLibraries : public testing::TestWithParam<std::size_t> {};

TEST_P(SizesOfLibraries, GiveWhatAScanGivesForTenThousandQueries) {
  const std::vector<CaseHead> library = random_library(GetParam(), GetParam());
  const CaseIndex index(library);
  Stream chance(GetParam(), "queries");
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Query query = random_query(chance, 1 + i % 4);
    const std::size_t most = 1 + chance.below(20);
    ASSERT_EQ(index.retrieve(query, most), retrieve_by_scan(library, query, most)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(CaseIndex, SizesOfLibraries, testing::Values(0, 1, 2, 17, 300, 1000, 5000),
                         testing::PrintToStringParamName());

TEST(CaseIndex, TellsAllCasesInTheOrderOfTheirRanks) {
  const std::vector<CaseHead> library = random_library(3, 3000);
  const CaseIndex index(library);
  Stream chance(3, "queries");
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Query query = random_query(chance, 1 + i % 4);
    ASSERT_EQ(index.retrieve(query, kAll), retrieve_by_scan(library, query, kAll)) << i;
  }
}

TEST(CaseIndex, TellsOlderCasesFirstAmongEquals) {
  std::vector<CaseHead> library = random_library(4, 400);
  for (CaseHead& head : library) {
    head.standing = 0;
    head.mark = 0;
  }
  const std::vector<Ranked> found = CaseIndex(library).retrieve({}, kAll);
  ASSERT_EQ(found.size(), library.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].id, i + 1);
}

TEST(CaseIndex, TellsCasesInTheSameOrderWhateverTheirNumbers) {
  std::vector<CaseHead> library = random_library(4, 400);
  for (CaseHead& head : library) head.mark = head.id * 7919 % 401;
  const auto marks = [&] {
    std::vector<std::uint64_t> told;
    for (const Ranked& one : CaseIndex(library).retrieve({}, kAll)) told.push_back(one.mark);
    return told;
  };
  const std::vector<std::uint64_t> before = marks();
  for (CaseHead& head : library) head.id = 401 - head.id;
  EXPECT_EQ(marks(), before);
}

TEST(CaseIndex, FindsACaseFirstByItsOwnFeaturesWhenItsStandingIsTheBest) {
  std::vector<CaseHead> library = random_library(5, 500);
  for (CaseHead& head : library) {
    const int before = head.standing;
    head.standing = 1000;
    ASSERT_EQ(CaseIndex(library).retrieve(query_of(head.features), 1).front().id, head.id);
    head.standing = before;
  }
}

TEST(CaseIndex, FindsACaseFirstByItsOwnFeaturesWhenNoOtherHasThem) {
  std::vector<CaseHead> library;
  CaseFeatures features;
  for (int robots = 1; robots <= kMostPlannedRobots; ++robots) {
    features.robots = robots;
    library.push_back({static_cast<CaseId>(robots), features, 0});
  }
  const CaseIndex index(library);
  for (const CaseHead& head : library) {
    EXPECT_EQ(index.retrieve(query_of(head.features), 1).front().id, head.id);
  }
}

TEST(CaseIndex, GivesTheSameInWhateverOrderCasesWereStored) {
  std::vector<CaseHead> library = random_library(6, 1000);
  const CaseIndex ordered(library);
  shuffle(library, 6);
  const CaseIndex grown = one_by_one(library);
  const CaseIndex built(library);
  Stream chance(6, "queries");
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Query query = random_query(chance, 1 + i % 4);
    ASSERT_EQ(grown.retrieve(query, 10), ordered.retrieve(query, 10)) << i;
    ASSERT_EQ(built.retrieve(query, 10), ordered.retrieve(query, 10)) << i;
  }
}

TEST(CaseIndex, FindsWhatWasStoredLast) {
  CaseIndex index(random_library(7, 1000));
  const CaseHead head{5000, usual_features(Task::SearchAndRescue), 1000};
  index.insert(head);
  EXPECT_EQ(index.size(), 1001U);
  EXPECT_EQ(index.retrieve(query_of(head.features), 1).front().id, 5000U);
}

TEST(CaseIndex, DoesNotFindWhatWasErased) {
  const std::vector<CaseHead> library = random_library(8, 200);
  CaseIndex index(library);
  EXPECT_TRUE(index.erase(17));
  EXPECT_FALSE(index.erase(17));
  EXPECT_EQ(index.size(), 199U);
  for (const Ranked& found : index.retrieve(query_of(library[16].features), kAll)) {
    EXPECT_NE(found.id, 17U);
  }
}

TEST(CaseIndex, IsEmptyWhenAllWasErased) {
  const std::vector<CaseHead> library = random_library(9, 300);
  CaseIndex index(library);
  for (const CaseHead& head : library) EXPECT_TRUE(index.erase(head.id));
  EXPECT_EQ(index.size(), 0U);
  EXPECT_TRUE(index.retrieve({}, 5).empty());
}

TEST(CaseIndex, RanksACaseAnewWhenItsStandingChanges) {
  const CaseFeatures features = usual_features(Task::ExplosiveOrdnance);
  CaseIndex index;
  index.insert({1, features, 0});
  index.insert({2, features, 0});
  EXPECT_EQ(index.retrieve(query_of(features), 1).front().id, 1U);
  TrackRecord record;
  take_outcome(record, 0.0);
  index.update({1, features, standing(record)});
  const std::vector<Ranked> found = index.retrieve(query_of(features), 2);
  EXPECT_EQ(found.front().id, 2U);
  EXPECT_EQ(found.back().rank, 5 * kStar - 333 * (kStar / 1000));
}

TEST(CaseIndex, GivesWhatAScanGivesWhileCasesComeGoAndChange) {
  std::vector<CaseHead> library = random_library(10, 400);
  CaseIndex index(library);
  Stream chance(10, "changes");
  for (CaseId id = 1000; id < 3000; ++id) {
    const std::size_t at = chance.below(library.size());
    if (chance.below(2) == 0) {
      ASSERT_TRUE(index.erase(library[at].id));
      library[at] = {id, random_features(chance), static_cast<int>(chance.below(2001)) - 1000};
      index.insert(library[at]);
    } else {
      library[at].features = random_features(chance);
      library[at].standing = static_cast<int>(chance.below(2001)) - 1000;
      index.update(library[at]);
    }
    const Query query = random_query(chance, 3);
    ASSERT_EQ(index.retrieve(query, 7), retrieve_by_scan(library, query, 7)) << id;
  }
}

TEST(CaseIndex, GivesNothingWhenNothingIsWanted) {
  const std::vector<CaseHead> library = random_library(11, 10);
  EXPECT_TRUE(CaseIndex(library).retrieve({}, 0).empty());
  EXPECT_TRUE(retrieve_by_scan(library, {}, 0).empty());
}

}  // namespace
}  // namespace tacit::cbr
