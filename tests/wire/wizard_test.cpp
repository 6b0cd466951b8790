#include <gtest/gtest.h>

#include <limits>

#include "idl/bus/convert_wizard.h"
#include "idl/wire/wizard.h"
#include "idl/wire/wizardPubSubTypes.h"

namespace tacit {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;

template <class Wire, class Support, class Word>
Word through_the_wire(const Word& word) {
  Wire sent;
  to_wire(word, sent);
  Support support;
  SerializedPayload_t payload(support.getSerializedSizeProvider(&sent)());
  EXPECT_TRUE(support.serialize(&sent, &payload));
  Wire received;
  EXPECT_TRUE(support.deserialize(&payload, &received));
  Word back;
  const Flaw flaw = from_wire(received, back);
  EXPECT_FALSE(flaw) << flaw.what;
  return back;
}

WizardRequest request(decltype(WizardRequest::what) what) { return {7, 3, std::move(what)}; }

WizardRequest returned(const WizardRequest& sent) {
  return through_the_wire<wire::WizardRequest, wire::WizardRequestPubSubType>(sent);
}

WizardReply returned(const WizardReply& sent) {
  return through_the_wire<wire::WizardReply, wire::WizardReplyPubSubType>(sent);
}

AskForPlans some_plans() {
  AskForPlans ask;
  ask.request.tasks = {
      {Task::Biohazard, -3.25, 1e6, Localization::UseMaps, {}, true},
      {Task::SearchAndRescue, 0.0, 0.125, {}, Environment::Outdoor, {}},
      {Task::Waypoints, 1.0, 2.0, Localization::UseLandmarks, Environment::Indoor, false}};
  ask.request.robots = 2;
  ask.request.enemy = true;
  ask.request.max_velocity_mps = 0.7;
  ask.request.aggressiveness = 0.6;
  ask.request.top = 5;
  ask.map = std::string(300'000, 'm') + "\xff\xfe";
  return ask;
}

PlanAnswer some_answer() {
  OfferedPlan plan;
  plan.stars = 4.25;
  plan.arrangement = "Every robot does every task.";
  plan.mission = std::string(200'000, 'c');
  plan.cases = {{9, "A case", 1, {{"Task", "", "BiohazardTask", true}}, "1 of 2 outcomes good"}};
  plan.changes = {{PlanChange::Step::Criticize, "no-end", "It had none.", "", "Terminate", false},
                  {PlanChange::Step::Adapt, "speed", "As was wanted.", "1", "0.5", true}};
  return {{plan, {}}, {"A note.", ""}};
}

TEST(WizardOnTheWire, KeepsEveryKindOfRequest) {
  AskForPlans open = some_plans();
  open.request.robots.reset();
  open.request.naive = true;
  for (const WizardRequest& sent :
       {request(some_plans()), request(open),
        request(ReportOutcome{{1, 1ULL << 63}, 0.875, {"Enter Lab: No."}, "office"}),
        request(StoreMission{"mission", "title", {{Task::Waypoints, 10}, {}}}),
        request(AskForState{})}) {
    EXPECT_EQ(returned(sent), sent);
  }
}

TEST(WizardOnTheWire, KeepsEveryKindOfReply) {
  for (const WizardReply& sent :
       {WizardReply{7, 3, WizardProgress{0.5, "plan 2 of 3"}}, WizardReply{7, 3, some_answer()},
        WizardReply{7, 3, WizardDone{12, "Stored."}}, WizardReply{7, 3, WizardRefusal{"No."}}}) {
    EXPECT_EQ(returned(sent), sent);
  }
}

template <class Spoil>
std::string_view flaw_of_request(const WizardRequest& word, Spoil spoil) {
  wire::WizardRequest wire;
  to_wire(word, wire);
  spoil(wire);
  WizardRequest back;
  return from_wire(wire, back).what;
}

template <class Spoil>
std::string_view flaw_of_reply(const WizardReply& word, Spoil spoil) {
  wire::WizardReply wire;
  to_wire(word, wire);
  spoil(wire);
  WizardReply back;
  return from_wire(wire, back).what;
}

TEST(WizardOnTheWire, RefusesRequestsThatNobodyCouldHaveMeant) {
  const WizardRequest plan = request(some_plans());
  const auto flaw = [&](auto spoil) { return flaw_of_request(plan, spoil); };
  EXPECT_EQ(flaw([](auto& wire) { wire.client(0); }), "client is 0");
  EXPECT_EQ(flaw([](auto& wire) { wire.number(0); }), "number is 0");
  EXPECT_EQ(flaw([](auto& wire) { wire.kind(4); }), "unknown kind of request");
  EXPECT_EQ(flaw([](auto& wire) { wire.tasks()[0].task(5); }), "unknown task");
  EXPECT_EQ(flaw([](auto& wire) { wire.tasks()[0].environment(3); }),
            "unknown environment of a task");
  EXPECT_EQ(flaw([](auto& wire) { wire.tasks()[0].x_m(std::numeric_limits<double>::quiet_NaN()); }),
            "a task's place is no number");
  EXPECT_EQ(flaw([](auto& wire) { wire.tasks().resize(1001); }), "more than 1000 tasks");
  EXPECT_EQ(flaw([](auto& wire) { wire.map_text(std::string(4'000'001, 'x')); }),
            "a map is longer than 4 MB");
  EXPECT_EQ(flaw([](auto& wire) { wire.enemy(2); }), "enemy is neither 0 nor 1");
  const WizardRequest outcome = request(ReportOutcome{{1}, 0.5, {}, ""});
  EXPECT_EQ(flaw_of_request(outcome, [](auto& wire) { wire.score(1.5); }),
            "an outcome's score is not in 0 to 1");
  const WizardRequest store = request(StoreMission{"m", "t", {{}}});
  EXPECT_EQ(flaw_of_request(store, [](auto& wire) { wire.features()[0].robots(0); }),
            "a case is for 1 to 10 robots");
}

TEST(WizardOnTheWire, RefusesRepliesThatNoWizardSends) {
  const WizardReply plans{7, 3, some_answer()};
  const auto flaw = [&](auto spoil) { return flaw_of_reply(plans, spoil); };
  EXPECT_EQ(flaw([](auto& wire) { wire.kind(4); }), "unknown kind of reply");
  EXPECT_EQ(flaw([](auto& wire) { wire.plans()[0].stars(6.0); }), "stars are not in 0 to 5");
  EXPECT_EQ(flaw([](auto& wire) { wire.plans().resize(21); }), "more than 20 plans");
  EXPECT_EQ(flaw([](auto& wire) { wire.plans()[0].changes()[0].step(2); }),
            "unknown step of a change");
}

/// What an honest wizard of another version could wish for is its to judge.
TEST(WizardOnTheWire, LeavesWhatIsWrongWithAPlanToTheWizard) {
  WizardRequest sent = request(AskForPlans{});
  std::get<AskForPlans>(sent.what).request.robots = 1000;
  std::get<AskForPlans>(sent.what).request.top = 0;
  EXPECT_EQ(returned(sent), sent);
  std::get<AskForPlans>(sent.what).request.robots = 0;
  EXPECT_EQ(returned(sent), sent);
}

}  // namespace
}  // namespace tacit
