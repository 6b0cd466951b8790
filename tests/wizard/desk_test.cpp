#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cases/some_cases.h"
#include "wizard_service/app/desk.h"

namespace tacit {
namespace {

using cbr::testing::Folder;
using cbr::testing::shipped_case;

std::string shipped_map(const std::string& name) {
  return cbr::testing::text_of(std::string(TACIT_SOURCE_DIR) + "/deploy/maps/" + name + ".ovl");
}

/// A desk with a few cases, and what it says.
class DeskTest : public testing::Test {
 protected:
  DeskTest() : base_(folder_.file()), desk_(base_) {}

  cbr::CaseBase& with_cases() {
    base_.store(shipped_case("biohazard", Task::Biohazard));
    base_.store(shipped_case("eod", Task::ExplosiveOrdnance));
    return base_;
  }

  std::vector<WizardReply> said(const WizardRequest& request) {
    std::vector<WizardReply> words;
    desk_.take(request, [&](const WizardReply& reply) { words.push_back(reply); });
    return words;
  }

  template <class Word>
  Word last(decltype(WizardRequest::what) what) {
    const std::vector<WizardReply> words = said({5, ++number_, std::move(what)});
    EXPECT_FALSE(words.empty());
    EXPECT_EQ(words.back().client, 5U);
    EXPECT_EQ(words.back().number, number_);
    const auto* word = std::get_if<Word>(&words.back().what);
    EXPECT_NE(word, nullptr) << words.back().what.index();
    return word == nullptr ? Word() : *word;
  }

  static AskForPlans ask(Task task = Task::Biohazard) {
    AskForPlans ask;
    ask.request.tasks = {{task, 30.0, 22.0, {}, {}, {}}};
    ask.request.robots = 1;
    ask.map = shipped_map("office");
    return ask;
  }

  std::string refusal(decltype(WizardRequest::what) what) {
    return last<WizardRefusal>(std::move(what)).text;
  }

  Folder folder_;
  cbr::CaseBase base_;
  Desk desk_;
  std::uint64_t number_ = 0;
};

TEST_F(DeskTest, PlansFromItsCases) {
  with_cases();
  const auto answer = last<PlanAnswer>(ask());
  ASSERT_FALSE(answer.plans.empty());
  EXPECT_EQ(answer.plans[0].cases.at(0).title, "From biohazard");
  EXPECT_FALSE(answer.plans[0].mission.empty());
}

TEST_F(DeskTest, SaysTheSameToARequestThatComesAgainAndDoesItOnce) {
  with_cases();
  const ReportOutcome report{{1}, 0.0, {"Enter Lab: nobody was there."}, "office"};
  const auto first = said({9, 1, report});
  const auto second = said({9, 1, report});
  EXPECT_EQ(first, second);
  EXPECT_EQ(base_.find(1).record.outcomes, 1U);
}

TEST_F(DeskTest, TakesAReportOnceAlsoWhenItWasStartedAnew) {
  with_cases();
  const WizardRequest report{9, 1, ReportOutcome{{1}, 1.0, {}, "office"}};
  said(report);
  Desk anew(base_);
  std::vector<WizardReply> words;
  anew.take(report, [&](const WizardReply& reply) { words.push_back(reply); });
  EXPECT_EQ(std::get<WizardDone>(words.at(0).what).text, "That was known already.");
  EXPECT_EQ(base_.find(1).record.outcomes, 1U);
  EXPECT_EQ(base_.find(1).record.uses, 1U);
}

TEST_F(DeskTest, PutsCasesThatDidWellInFront) {
  with_cases();
  cbr::Case twin = shipped_case("biohazard", Task::Biohazard);
  twin.title = "Twin";
  // Of two that fit alike the one that was there first leads; it must differ to be another.
  twin.plan.robots[0].states.push_back(twin.plan.robots[0].states.back());
  twin.plan.robots[0].states.back().name = "$AN_9999";
  twin.plan.robots[0].states.front().rules.push_back(twin.plan.robots[0].states.front().rules[0]);
  twin.plan.robots[0].states.front().rules.back().target = "$AN_9999";
  const CaseId id = base_.store(twin).id;
  ASSERT_EQ(last<PlanAnswer>(ask()).plans.at(0).cases.at(0).title, "From biohazard");
  (void)last<WizardDone>(ReportOutcome{{1}, 0.0, {"Enter Lab: nobody."}, "office"});
  (void)last<WizardDone>(ReportOutcome{{id}, 1.0, {}, "office"});
  const auto after = last<PlanAnswer>(ask());
  EXPECT_EQ(after.plans.at(0).cases.at(0).title, "Twin");
}

TEST_F(DeskTest, StoresAMissionOnceAndPlansFromIt) {
  const std::string mission =
      cbr::testing::text_of(std::string(TACIT_SOURCE_DIR) + "/deploy/missions/biohazard.cdl");
  const StoreMission store{mission, "Mine", {cbr::usual_features(Task::Biohazard)}};
  EXPECT_EQ(last<WizardDone>(store).text, "Stored 1 new case.");
  EXPECT_EQ(last<WizardDone>(store).text, "Stored 0 new cases; 1 was there.");
  EXPECT_EQ(last<PlanAnswer>(ask()).plans.at(0).cases.at(0).title.substr(0, 4), "Mine");
}

TEST_F(DeskTest, SeesWhatOthersDoToTheCaseBase) {
  EXPECT_NE(refusal(ask()).find("no case"), std::string::npos);
  cbr::CaseBase other(folder_.file());
  other.store(shipped_case("biohazard", Task::Biohazard));
  EXPECT_FALSE(last<PlanAnswer>(ask()).plans.empty());
}

TEST_F(DeskTest, RefusesWhatCannotBeAndGoesOn) {
  with_cases();
  AskForPlans empty = ask();
  empty.request.tasks.clear();
  EXPECT_FALSE(refusal(empty).empty());
  AskForPlans crowd = ask();
  crowd.request.robots = 1000;
  EXPECT_NE(refusal(crowd).find("1000"), std::string::npos);
  AskForPlans none = ask();
  none.request.robots = 0;
  EXPECT_NE(refusal(none).find('0'), std::string::npos);
  AskForPlans outside = ask();
  outside.request.tasks[0].x_m = 1e5;
  EXPECT_NE(refusal(outside).find("wanted a place on the map"), std::string::npos);
  AskForPlans nowhere = ask();
  nowhere.map = "MISSION-AREA 1 2 nonsense\n";
  EXPECT_NE(refusal(nowhere).find("map"), std::string::npos);
  EXPECT_FALSE(refusal(StoreMission{"no mission", "t", {{}}}).empty());
  EXPECT_FALSE(refusal(ReportOutcome{{99}, 1.0, {}, ""}).empty());
  EXPECT_FALSE(refusal(ReportOutcome{{}, 1.0, {}, ""}).empty());
  EXPECT_FALSE(last<PlanAnswer>(ask()).plans.empty());
}

TEST_F(DeskTest, TellsHowManyCasesItHas) {
  with_cases();
  EXPECT_EQ(last<WizardDone>(AskForState{}).text, "Has 2 cases.");
}

TEST_F(DeskTest, ForgetsOldAnswersAndKeepsTheNewest) {
  Answered answered;
  for (std::uint64_t i = 1; i <= Answered::kMost + 1; ++i) {
    answered.keep({1, i, WizardDone{i, ""}});
  }
  EXPECT_EQ(answered.find(1, 1), nullptr);
  ASSERT_NE(answered.find(1, 2), nullptr);
  PlanAnswer large;
  large.plans.resize(1);
  large.plans[0].mission.resize(Answered::kMostBytes);
  answered.keep({2, 1, large});
  EXPECT_NE(answered.find(2, 1), nullptr);
  EXPECT_EQ(answered.find(1, Answered::kMost + 1), nullptr);
}

}  // namespace
}  // namespace tacit
