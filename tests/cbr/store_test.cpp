#include "wizard_service/cbr/store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/join.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& file) {
  std::ifstream in(fs::path(TACIT_SOURCE_DIR) / "deploy" / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

Plan shipped(const std::string& name) { return plan_of(text_of("missions/" + name), name); }

/// One robot that looks for something and goes to it, again and again until it is told to stop.
Plan searching(const std::string& what) {
  RobotPlan robot;
  robot.name = "Seeker";
  const std::vector<Given> seek{{"Objects", what}};
  robot.states = {{"Start", "Start", behaviour("Stop"), {{behaviour("Immediate"), "Look"}}},
                  {"Look", "Look", behaviour("LookFor", seek), {{behaviour("Detect", seek), "Go"}}},
                  {"Go",
                   "Go",
                   behaviour("MoveToward", seek),
                   {{behaviour("NotDetected", seek), "Look"}, {behaviour("Near", seek), "End"}}},
                  {"End", "End", behaviour("Terminate"), {}}};
  return {{}, {robot}};
}

Plan waiting() {
  RobotPlan robot;
  robot.states = {{"Start", "", behaviour("Stop"), {{behaviour("Immediate"), "End"}}},
                  {"End", "", behaviour("Terminate"), {}}};
  return {{}, {robot}};
}

/// Both one after another, as MissionLab joins them: an end waits for nothing and goes on.
RobotPlan joined(const RobotPlan& a, const RobotPlan& b) {
  RobotPlan robot = a;
  robot.states = {{"Start", "", behaviour("Stop"), {{behaviour("Immediate"), "To1"}}},
                  {"To1",
                   "First",
                   behaviour("StartSubMission"),
                   {{behaviour("SubMissionReady"), "1" + a.states[0].rules[0].target}}},
                  {"To2", "Way to 2", behaviour("GoTo"), {{behaviour("AtGoal"), "Begin2"}}},
                  {"Begin2",
                   "Second",
                   behaviour("StartSubMission"),
                   {{behaviour("SubMissionReady"), "2" + b.states[0].rules[0].target}}}};
  const auto add = [&robot](const RobotPlan& part, const std::string& prefix, bool goes_on) {
    for (PlanState state : part.states) {
      if (state.name == "Start") continue;
      state.name = prefix + state.name;
      for (PlanRule& rule : state.rules) rule.target = prefix + rule.target;
      if (goes_on && state.rules.empty()) {
        state.behaviour = behaviour("Stop");
        state.rules = {{behaviour("Immediate"), "To2"}};
      }
      robot.states.push_back(state);
    }
  };
  add(a, "1", true);
  add(b, "2", false);
  return robot;
}

std::vector<CaseFeatures> two_features() {
  return {usual_features(Task::Biohazard), usual_features(Task::Waypoints)};
}

TEST(Pieces, OfTwoPlansThatWereJoinedAreTheTwo) {
  const std::vector<Plan> plans{searching("Brown"), searching("Red"), waiting()};
  for (const Plan& a : plans) {
    for (const Plan& b : plans) {
      const Plan both{{}, {joined(a.robots[0], b.robots[0])}};
      const std::vector<Case> pieces = pieces_of(both, two_features(), "Both");
      ASSERT_EQ(pieces.size(), 2U);
      EXPECT_EQ(likeness(pieces[0].plan), likeness(a));
      EXPECT_EQ(likeness(pieces[1].plan), likeness(b));
    }
  }
}

TEST(Pieces, OfAMissionThatTheWizardJoinedAreItsCases) {
  const Terrain terrain(read_overlay(text_of("maps/office.ovl")).map);
  const MapPoint here = terrain.start();
  const Plan pair = shipped("biohazard_pair.cdl");
  const std::vector<Piece> joint{{"BiohazardTask 1", "1", pair, {here, {here}, false}},
                                 {"BiohazardTask 2", "2", pair, {here, {here, here}, true}}};
  Changes changes;
  const Plan both = join(joint, terrain, false, changes);
  const std::vector<Case> pieces = pieces_of(both, two_features(), "Both");
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(likeness(pieces[0].plan), likeness(pieces[1].plan));
  EXPECT_EQ(likeness(pieces[0].plan), likeness(pair));
  EXPECT_EQ(pieces[0].features.robots, 2);
}

TEST(Pieces, ReadFromTheirOwnTextAreWhatTheyWere) {
  const Plan both{{}, {joined(searching("Brown").robots[0], searching("Red").robots[0])}};
  for (const Case& piece : pieces_of(both, two_features(), "Both")) {
    ASSERT_EQ(piece.plan.robots[0].states.front().name, "Start");
    ASSERT_EQ(piece.plan.robots[0].states.back().label,
              piece.features.task == Task::Biohazard ? "Done" : "End");
  }
}

TEST(Pieces, TakeTheRobotsThatHaveThem) {
  const RobotPlan seeker = searching("Brown").robots[0];
  RobotPlan once = joined(seeker, seeker);
  std::erase_if(once.states, [](const PlanState& state) { return state.label == "Second"; });
  const Plan plan{{}, {joined(seeker, seeker), once}};
  const std::vector<Case> pieces = pieces_of(plan, two_features(), "Both");
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].features.robots, 2);
  EXPECT_EQ(pieces[1].features.robots, 1);
}

TEST(Pieces, BelongTogetherByTheNumberThatTheySay) {
  RobotPlan first = joined(searching("Brown").robots[0], waiting().robots[0]);
  first.states[1].label = "BiohazardTask 1";
  first.states[3].label = "WaypointsTask 3";
  RobotPlan second = first;
  second.states[1].label = "WaypointsTask 2";
  const std::vector<Case> pieces = pieces_of({{}, {first, second}}, two_features(), "All");
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].features.robots, 1);
  EXPECT_EQ(pieces[1].features.robots, 1);
  EXPECT_EQ(pieces[2].features.robots, 2);
  EXPECT_EQ(pieces[2].features.task, Task::Waypoints);
}

TEST(Pieces, OfAPlanWithoutSubMissionsAreThePlan) {
  const Plan plan = shipped("biohazard.cdl");
  const std::vector<Case> pieces = pieces_of(plan, two_features(), "Search");
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].plan, plan);
  EXPECT_EQ(pieces[0].title, "Search");
}

TEST(Pieces, LeaveOutWhatTheyDoNotRefer) {
  Plan both{{}, {joined(searching("Brown").robots[0], searching("Red").robots[0])}};
  cdl::Statement shared;
  shared.kind = cdl::Statement::Kind::Instantiation;
  shared.name = "$AN_900";
  shared.body = behaviour("Wait");
  both.shared.push_back(shared);
  for (PlanState& state : both.robots[0].states) {
    if (state.name != "1Look") continue;
    state.rules[0].trigger = {};
    state.rules[0].trigger.kind = cdl::Expression::Kind::Reference;
    state.rules[0].trigger.name = "$AN_900";
  }
  const std::vector<Case> pieces = pieces_of(both, two_features(), "Both");
  EXPECT_EQ(pieces[0].plan.shared.size(), 1U);
  EXPECT_TRUE(pieces[1].plan.shared.empty());
}

TEST(Pieces, WithoutFeaturesAreRefused) {
  EXPECT_THROW((void)pieces_of(waiting(), {}, "Nothing"), ConfigError);
}

TEST(Likeness, IgnoresNamesLabelsPlacesAndVelocities) {
  Plan plan = searching("Brown");
  const std::string before = likeness(plan);
  RobotPlan& robot = plan.robots[0];
  robot.name = "Other";
  robot.max_mps = 2.0;
  for (PlanState& state : robot.states) {
    if (state.name != "Start") state.name += "X";
    state.label += "Y";
    state.behaviour.place = cdl::Place{1, 2};
    for (PlanRule& rule : state.rules) rule.target += "X";
  }
  std::reverse(robot.states.begin(), robot.states.end());
  EXPECT_EQ(likeness(plan), before);
}

TEST(Likeness, TellsParametersApart) {
  EXPECT_NE(likeness(searching("Brown")), likeness(searching("Red")));
}

TEST(Likeness, TellsRulesAndTheirOrderApart) {
  Plan plan = searching("Brown");
  const std::string before = likeness(plan);
  std::swap(plan.robots[0].states[2].rules[0], plan.robots[0].states[2].rules[1]);
  EXPECT_NE(likeness(plan), before);
  plan = searching("Brown");
  plan.robots[0].states[2].rules[0].target = "Go";
  EXPECT_NE(likeness(plan), before);
  plan.robots.push_back(plan.robots[0]);
  EXPECT_NE(likeness(plan), likeness(searching("Brown")));
}

TEST(Likeness, IgnoresTheOrderOfSharedGroups) {
  Plan plan = shipped("biohazard_pair.cdl");
  const std::string before = likeness(plan);
  plan.shared.insert(plan.shared.begin(), plan.shared.front());
  plan.shared.front().name = "Unused";
  EXPECT_EQ(likeness(plan), before);
}

TEST(Likeness, OfAGroupThatRefersToItselfIsTold) {
  Plan plan = waiting();
  cdl::Statement circle;
  circle.name = "Round";
  circle.body = behaviour("Round", {{"a", "1"}});
  plan.shared.push_back(circle);
  plan.robots[0].states[1].behaviour = behaviour("Round");
  EXPECT_FALSE(likeness(plan).empty());
}

}  // namespace
}  // namespace tacit::cbr
