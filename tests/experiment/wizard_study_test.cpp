#include "deploy/experiment/wizard_study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "deploy/experiment/wizard_study_tables.h"
#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "tests/cbr/shelf.h"
#include "tests/lockstep/operations.h"

namespace tacit {
namespace {

WizardStudy small_study() {
  WizardStudy study;
  study.sites = 2;
  study.first = 11;
  study.expert_alone = testing::shipped_mission("biohazard");
  study.expert_team = testing::shipped_mission("biohazard_pair");
  study.sentry = testing::shipped_mission("sentry");
  return study;
}

std::vector<StudyFlight> flown(const WizardStudy& study, unsigned workers) {
  cbr::CaseShelf cases(cbr::testing::Shelf().all());
  return study_flights(study, cases, {workers, {}}, {});
}

MapPlan plan_of(const NamedText& map) { return plan_of(read_overlay(map.text).map, Doors::Open); }

TEST(WizardStudy, AsksForTheWayPointsTheEntryAndASearch) {
  const PlanRequest request = study_request(plan_of(study_site(3)), 2);
  ASSERT_EQ(request.tasks.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(request.tasks[i].task, Task::Waypoints);
  EXPECT_EQ(request.tasks[3].task, Task::Biohazard);
  EXPECT_TRUE(request.enemy);
  EXPECT_FALSE(study_request(plan_of(study_site(3)), 1).enemy);
}

TEST(WizardStudy, GivesTheExpertTheSameBuilding) {
  const MapPlan site = plan_of(study_site(3));
  const MapPlan building = plan_of(study_building(3));
  ASSERT_EQ(site.rooms.size(), building.rooms.size());
  EXPECT_EQ(site.doors.size(), building.doors.size());
  EXPECT_EQ(site.objects.size(), building.objects.size());
  EXPECT_EQ(site.ground.size.height_m, building.ground.size.height_m);
}

TEST(WizardStudy, FliesEveryTeamAndPlannerOnEverySite) {
  const std::vector<StudyFlight> flights = flown(small_study(), 2);
  ASSERT_EQ(flights.size(), 12U);
  EXPECT_EQ(flights.front().flight.seed, 11U);
  EXPECT_EQ(flights.back().flight.seed, 12U);
  for (const StudyFlight& one : flights) {
    EXPECT_EQ(one.refusal, "");
    EXPECT_GT(one.flight.list.wanted(), 4U);
    EXPECT_EQ(one.score() > 0.6, one.planner != Planner::Naive) << word(one.planner) << one.score();
  }
}

TEST(WizardStudy, IsTheSameForAnyNumberOfThreads) {
  WizardStudy study = small_study();
  study.planners = {Planner::Wizard, Planner::Expert};
  EXPECT_EQ(to_csv(study_flights_table(flown(study, 1), "v")),
            to_csv(study_flights_table(flown(study, 2), "v")));
}

TEST(WizardStudy, CountsAPlanThatCannotBeMadeAsNothingDone) {
  WizardStudy study = small_study();
  study.planners = {Planner::Wizard};
  cbr::CaseShelf cases(cbr::testing::Shelf("eod").all());
  const std::vector<StudyFlight> flights = study_flights(study, cases, {1, {}}, {});
  ASSERT_EQ(flights.size(), 4U);
  EXPECT_NE(flights[0].refusal.find("found no case for"), std::string::npos);
  EXPECT_EQ(flights[0].score(), 0.0);
  EXPECT_FALSE(flights[0].full());
  EXPECT_EQ(study_failures(flights).rows.size(), 4U);
}

TEST(WizardStudy, EndsEarlyWhenToldTo) {
  WizardStudy study = small_study();
  study.sites = 1000;
  study.planners = {Planner::Expert};
  study.robots = {1};
  std::stop_source source;
  const CrewOptions options{1, [&](const CrewProgress& progress) {
                              if (progress.done == 2) source.request_stop();
                            }};
  cbr::CaseShelf cases(cbr::testing::Shelf().all());
  EXPECT_EQ(study_flights(study, cases, options, source.get_token()).size(), 2U);
}

TEST(WizardStudy, RefusesWhatMakesNoSense) {
  WizardStudy study = small_study();
  study.robots = {11};
  EXPECT_THROW((void)flown(study, 1), ConfigError);
  study.robots = {};
  EXPECT_THROW((void)flown(study, 1), ConfigError);
  study = small_study();
  study.sites = 0;
  EXPECT_THROW((void)flown(study, 1), ConfigError);
}

StudyFlight told(int robots, Planner planner, std::uint64_t site, std::size_t done) {
  StudyFlight one{robots, planner, {}, {}};
  one.flight.seed = site;
  for (std::size_t i = 0; i < 10; ++i) {
    one.flight.list.tasks.push_back({"Task " + std::to_string(i), i < done, ""});
  }
  return one;
}

TEST(StudyTable, HasARowForEachTeamAndPlanner) {
  std::vector<StudyFlight> flights;
  for (std::uint64_t site = 1; site <= 10; ++site) {
    flights.push_back(told(2, Planner::Wizard, site, site <= 7 ? 9 : 8));
    flights.push_back(told(1, Planner::Naive, site, 2));
  }
  const Table table = study_table(flights);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][0], TableCell(std::int64_t{1}));
  EXPECT_EQ(table.rows[0][1], TableCell(std::string("naive")));
  const auto& good = std::get<Estimate>(table.rows[1][4]);
  EXPECT_NEAR(good.value, 0.7, 1e-12);
  EXPECT_NEAR(good.low, 0.3968, 5e-5);
  EXPECT_NEAR(good.high, 0.8922, 5e-5);
  EXPECT_EQ(std::get<Estimate>(table.rows[1][5]).value, 0.0);
}

TEST(StudyFailures, NameTheSiteAndWhatIsMissing) {
  const Table table = study_failures(std::vector<StudyFlight>{told(1, Planner::Wizard, 5, 8),
                                                              told(1, Planner::Wizard, 6, 10),
                                                              told(1, Planner::Naive, 7, 2)});
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0][2], TableCell(std::int64_t{5}));
  EXPECT_EQ(table.rows[0][4], TableCell(std::string("Task 8, Task 9")));
}

}  // namespace
}  // namespace tacit
