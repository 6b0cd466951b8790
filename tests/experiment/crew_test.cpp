#include "deploy/experiment/crew.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>

namespace tacit {
namespace {

std::optional<std::size_t> squared(std::size_t i) { return i * i; }

TEST(Crew, GivesWhatComesOfEachJobInTheirOrder) {
  for (const unsigned workers : {0U, 1U, 2U, 7U}) {
    const auto made = made_by_crew(50, {workers, {}}, {}, squared);
    ASSERT_EQ(made.size(), 50U);
    for (std::size_t i = 0; i < made.size(); ++i) EXPECT_EQ(made[i], i * i);
  }
}

TEST(Crew, TellsOfTheStartAndOfEveryJob) {
  std::vector<std::size_t> done;
  const CrewOptions options{3, [&](const CrewProgress& progress) {
                              EXPECT_EQ(progress.all, 20U);
                              done.push_back(progress.done);
                            }};
  (void)made_by_crew(20, options, {}, squared);
  std::vector<std::size_t> wanted(21);
  std::iota(wanted.begin(), wanted.end(), 0U);
  EXPECT_EQ(done, wanted);
}

TEST(Crew, BeginsNothingMoreOnceToldToStop) {
  std::stop_source source;
  const auto made = made_by_crew(1000, {2, {}}, source.get_token(), [&](std::size_t i) {
    if (i == 10) source.request_stop();
    return squared(i);
  });
  EXPECT_EQ(made[10], 100U);
  EXPECT_EQ(made[20], std::nullopt);
  EXPECT_EQ(made.back(), std::nullopt);
}

TEST(Crew, ThrowsWhatAJobThrewAndBeginsNoMore) {
  std::atomic<std::size_t> begun = 0;
  const auto job = [&](std::size_t i) -> std::optional<int> {
    ++begun;
    if (i == 3) throw std::runtime_error("no");
    return 1;
  };
  EXPECT_THROW((void)made_by_crew(1000, {1, {}}, {}, job), std::runtime_error);
  EXPECT_EQ(begun, 4U);
}

TEST(Crew, DoesWithoutJobs) { EXPECT_TRUE(made_by_crew(0, {2, {}}, {}, squared).empty()); }

}  // namespace
}  // namespace tacit
