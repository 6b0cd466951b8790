#include "robot_agent/brain/fsa/automaton.h"

#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "tests/brain/forage_surroundings.h"

namespace tacit {
namespace {

using testing::base;
using testing::enemy;
using testing::ForageEyes;
using testing::mine;

const ActivityPlan kToMine{{{"MoveTo", 2.0, Thing::Mine}}, {.act = Act::PickUp}};
const ActivityPlan kToBase{{{"MoveTo", 1.0, Thing::Base}}, {.act = Act::Drop}};

/// An automaton that is shown one scene after the other.
class Shown {
 public:
  explicit Shown(const AutomatonPlan& plan) : automaton_(plan, SchemaConfigs{}, Self{}) {
    automaton_.enter({eyes_.next_tick(), {}});
    eyes_.look(std::vector<Sighting>{});
  }
  Doing show(std::vector<Sighting> sightings) {
    return automaton_.step(eyes_.look(std::move(sightings)));
  }
  [[nodiscard]] Automaton& automaton() { return automaton_; }
  [[nodiscard]] std::string state() const { return std::string(automaton_.state()); }

 private:
  ForageEyes eyes_;
  Automaton automaton_;
};

TEST(Automaton, BeginsInTheFirstState) {
  Shown shown({"test", {{"A", kToMine, {}}}});
  EXPECT_EQ(shown.state(), "A");
}

TEST(Automaton, DoesWhatItsStateSaysWhileNoRuleFires) {
  Shown shown({"test", {{"A", kToMine, {{Detect{Thing::Enemy}, "A"}}}}});
  const Doing doing = shown.show({mine(5, 0)});
  EXPECT_EQ(doing.sum, BodyVec(2, 0));
  EXPECT_EQ(doing.act, Act::PickUp);
}

TEST(Automaton, FollowsTheFirstRuleThatFires) {
  Shown shown(
      {"test",
       {{"A", {}, {{Detect{Thing::Enemy}, "B"}, {Detect{Thing::Mine}, "C"}, {Immediate{}, "D"}}},
        {"B", {}, {}},
        {"C", {}, {}},
        {"D", {}, {}}}});
  static_cast<void>(shown.show({mine(5, 0)}));
  EXPECT_EQ(shown.state(), "C");
}

TEST(Automaton, MakesOneTransitionPerTick) {
  Shown shown(
      {"test", {{"A", {}, {{Immediate{}, "B"}}}, {"B", {}, {{Immediate{}, "C"}}}, {"C", {}, {}}}});
  static_cast<void>(shown.show({}));
  EXPECT_EQ(shown.state(), "B");
  static_cast<void>(shown.show({}));
  EXPECT_EQ(shown.state(), "C");
}

TEST(Automaton, DoesNothingInTheTickInWhichAStateIsEntered) {
  Shown shown({"test", {{"A", kToMine, {{Detect{Thing::Base}, "B"}}}, {"B", kToBase, {}}}});
  const Doing entering = shown.show({mine(5, 0), base(0, 3)});
  EXPECT_EQ(entering.sum, BodyVec());
  EXPECT_EQ(entering.act, Act::None);
  const Doing then = shown.show({mine(5, 0), base(0, 3)});
  EXPECT_EQ(then.sum, BodyVec(0, 1));
  EXPECT_EQ(then.act, Act::Drop);
}

TEST(Automaton, HeedsTheRulesOfItsCurrentStateAlone) {
  Shown shown({"test",
               {{"A", {}, {{Detect{Thing::Mine}, "B"}}},
                {"B", {}, {{Detect{Thing::Enemy}, "C"}}},
                {"C", {}, {}}}});
  static_cast<void>(shown.show({enemy(5, 0)}));
  EXPECT_EQ(shown.state(), "A");
}

TEST(Automaton, TellsTriggersWhenTheirStateIsEnteredAgain) {
  Shown shown({"test", {{"A", {}, {{Wait{2}, "B"}}}, {"B", {}, {{Immediate{}, "A"}}}}});
  std::string states;
  for (int i = 0; i < 7; ++i) {
    static_cast<void>(shown.show({}));
    states += shown.state();
  }
  EXPECT_EQ(states, "ABAABAA");
}

TEST(Automaton, EnteredAnewBeginsInTheFirstStateAgain) {
  Shown shown({"test", {{"A", {}, {{Immediate{}, "B"}}}, {"B", {}, {}}}});
  static_cast<void>(shown.show({}));
  shown.automaton().enter({7, {}});
  EXPECT_EQ(shown.state(), "A");
  EXPECT_EQ(shown.automaton().entered().tick, 7U);
}

TEST(Automaton, GoesOnInTheMiddleOfAState) {
  const AutomatonPlan plan{"test", {{"A", {}, {{Wait{0}, "B"}}}, {"B", {}, {{Wait{5}, "A"}}}}};
  Automaton automaton(plan, SchemaConfigs{}, Self{});
  automaton.resume("B", {10, {}});
  Surroundings around;
  around.tick = 14;
  static_cast<void>(automaton.step(around));
  EXPECT_EQ(automaton.state(), "B");
  around.tick = 15;
  static_cast<void>(automaton.step(around));
  EXPECT_EQ(automaton.state(), "A");
}

TEST(Automaton, ReportsTheSharesOfItsState) {
  Shown shown({"test", {{"A", {{{"MoveTo", 2.0, Thing::Mine}, {"Noise", 0.0, {}}}, {}}, {}}}});
  static_cast<void>(shown.show({mine(5, 0)}));
  std::vector<SchemaShare> shares(3);
  shown.automaton().report(shares);
  ASSERT_EQ(shares.size(), 1U);
  EXPECT_EQ(shares[0].name, "MoveToMine");
  EXPECT_EQ(shares[0].gain, 2.0);
  EXPECT_EQ(shares[0].push, BodyVec(1, 0));
}

TEST(Automaton, ReportsNoPushFromBeforeItsStateWasEntered) {
  Shown shown(
      {"test", {{"A", kToMine, {{Detect{Thing::Base}, "B"}}}, {"B", {}, {{Immediate{}, "A"}}}}});
  static_cast<void>(shown.show({mine(5, 0)}));
  static_cast<void>(shown.show({base(1, 0)}));
  static_cast<void>(shown.show({mine(5, 0)}));
  std::vector<SchemaShare> shares;
  shown.automaton().report(shares);
  ASSERT_EQ(shares.size(), 1U);
  EXPECT_EQ(shares[0].push, BodyVec());
}

std::string refusal(const AutomatonPlan& plan) {
  try {
    const Automaton automaton(plan, SchemaConfigs{}, Self{});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Automaton, IsRefusedWithoutStates) {
  EXPECT_EQ(refusal({"test", {}}), "automaton test: it has no states");
}

TEST(Automaton, IsRefusedWhenARuleLeadsNowhere) {
  EXPECT_EQ(refusal({"test", {{"A", {}, {{Immediate{}, "Z"}}}}}),
            "automaton test: state A goes to Z, wanted one of its states");
}

TEST(Automaton, IsRefusedWhenAStateCannotBeReached) {
  EXPECT_EQ(refusal({"test", {{"A", {}, {}}, {"B", {}, {{Immediate{}, "A"}}}}}),
            "automaton test: state B cannot be reached");
}

TEST(Automaton, IsRefusedWhenANameOccursTwice) {
  EXPECT_EQ(refusal({"test", {{"A", {}, {}}, {"A", {}, {}}}}),
            "automaton test: state A occurs twice");
}

TEST(Automaton, IsRefusedWithASchemaThatIsNot) {
  EXPECT_EQ(refusal({"test", {{"A", {{{"Fly", 1.0, {}}}, {}}, {}}}}),
            "automaton test: state A: there is no schema called Fly");
}

TEST(Automaton, IsRefusedWithASchemaThatLacksItsThing) {
  EXPECT_EQ(refusal({"test", {{"A", {{{"MoveTo", 1.0, {}}}, {}}, {}}}}),
            "automaton test: state A: schema MoveTo lacks a thing to be about");
}

TEST(Automaton, IsRefusedWithMoreSchemasThanTelemetryShows) {
  const std::vector<SchemaUse> many(Telemetry::kMaxShares + 1, {"Noise", 1.0, {}});
  EXPECT_EQ(refusal({"test", {{"A", {many, {}}, {}}}}),
            "automaton test: state A: an activity has 17 schemas, wanted at most 16");
}

}  // namespace
}  // namespace tacit
