#include "deploy/experiment/preview.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "deploy/lockstep/operation_setup.h"
#include "idl/types/config_error.h"
#include "tests/lockstep/operations.h"

namespace tacit {
namespace {

Setup operation(const std::string& mission, const std::string& map) {
  OperationWish wish;
  wish.mission = testing::shipped_mission(mission);
  wish.map = testing::shipped_map(map);
  return operation_setup(wish);
}

/// One that goes another way with every seed.
Setup noisy_search() {
  Setup setup = operation("biohazard", "office");
  setup.world.sight.bearing_noise_deg = 20.0;
  setup.world.sight.range_noise_m = 0.5;
  return setup;
}

bool same(const Flight& a, const Flight& b) {
  return a.seed == b.seed && a.list.tasks == b.list.tasks && a.time_s == b.time_s &&
         a.over == b.over;
}

Preview flown(const Setup& setup, const PreviewWish& wish, unsigned workers = 1) {
  return preview(setup, wish, {workers, {}}, {});
}

Flight flight_of(std::size_t done, double time_s) {
  Flight flight;
  for (std::size_t i = 0; i < 4; ++i) {
    flight.list.tasks.push_back({"Task " + std::to_string(i), i < done, "because"});
  }
  flight.time_s = time_s;
  return flight;
}

TEST(Preview, IsTheSameForAnyNumberOfThreads) {
  const auto setup = noisy_search();
  const Preview one = flown(setup, {7, 8}, 1);
  const Preview two = flown(setup, {7, 8}, 2);
  ASSERT_EQ(one.flights.size(), 8U);
  EXPECT_FALSE(one.alike());
  EXPECT_TRUE(std::equal(one.flights.begin(), one.flights.end(), two.flights.begin(),
                         two.flights.end(), same));
}

TEST(Preview, FliesTheSeedsFromTheFirstOn) {
  const auto setup = noisy_search();
  const Preview many = flown(setup, {7, 3});
  EXPECT_EQ(many.flights[0].seed, 7U);
  EXPECT_TRUE(same(many.flights[2], flown(setup, {9, 1}).flights.at(0)));
}

TEST(Preview, GoesAsTheOperationDoes) {
  OperationWish wish;
  wish.mission = testing::shipped_mission("eod");
  wish.map = testing::shipped_map("minefield");
  const testing::Outcome outcome = testing::carry_out(wish, 3);
  const Preview made = flown(operation_setup(wish), {3, 1});
  EXPECT_EQ(made.flights.at(0).list.tasks, outcome.list.tasks);
  EXPECT_DOUBLE_EQ(made.flights[0].time_s, static_cast<double>(outcome.ticks) * 0.1);
}

TEST(Preview, TellsWhenTheSeedChangesNothing) {
  EXPECT_TRUE(flown(operation("biohazard", "office"), {1, 3}).alike());
  EXPECT_FALSE(flown(operation("biohazard", "office"), {1, 1}).alike());
}

TEST(Preview, EndsEarlyWhenToldToAndKeepsWhatWasFlown) {
  std::stop_source source;
  const CrewOptions options{2, [&](const CrewProgress& progress) {
                              if (progress.done == 3) source.request_stop();
                            }};
  const Preview made = preview(noisy_search(), {1, 1000}, options, source.get_token());
  EXPECT_TRUE(made.cut_short());
  EXPECT_GE(made.flights.size(), 3U);
  EXPECT_LT(made.flights.size(), 6U);
  EXPECT_EQ(made.wanted, 1000U);
}

TEST(Preview, GivesUpAFlightUnderWay) {
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(fly(noisy_search(), 1, source.get_token()), std::nullopt);
}

TEST(Preview, CountsFullChecklistsAndWhatFailed) {
  Preview made;
  made.wanted = 10;
  for (int i = 0; i < 7; ++i) made.flights.push_back(flight_of(4, 100.0 + i));
  for (int i = 0; i < 2; ++i) made.flights.push_back(flight_of(3, 300.0));
  made.flights.push_back(flight_of(2, 300.0));
  made.flights.back().seed = 9;
  EXPECT_NEAR(made.success().value().low, 0.3968, 5e-5);
  EXPECT_NEAR(made.success().value().high, 0.8922, 5e-5);
  EXPECT_DOUBLE_EQ(made.score().value().value, 0.9);
  EXPECT_LE(made.score().value().high, 1.0);
  EXPECT_EQ(made.time_s(), (Estimate{104.5, 101.0, 300.0}));
  const std::vector<Weakness> wanted{{"Task 3", 3, 0, "because"}, {"Task 2", 1, 9, "because"}};
  EXPECT_EQ(made.weaknesses(), wanted);
  EXPECT_EQ(made.flights.back().failures(),
            (std::vector<std::string>{"Task 2: because", "Task 3: because"}));
}

TEST(Preview, RefusesWhatCannotBeFlown) {
  EXPECT_THROW((void)flown(setup_for(MissionKind::Guard), {1, 1}), ConfigError);
  EXPECT_THROW((void)flown(operation("eod", "minefield"), {1, 0}), ConfigError);
}

}  // namespace
}  // namespace tacit
