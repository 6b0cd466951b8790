#include "idl/cdl/resolve.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "idl/cdl/diagram.h"
#include "idl/cdl/parse.h"
#include "tests/cdl/samples.h"

namespace tacit::cdl {
namespace {

std::vector<Robot> robots(const std::string& text) { return resolve(parse(text).mission).robots; }

Value value_of(const std::vector<Parameter>& parameters, const std::string& name) {
  for (const Parameter& parameter : parameters) {
    if (parameter.name == name) {
      return parameter.value;
    }
  }
  return NoValue{};
}

TEST(Resolve, FollowsTheTeamToItsAutomata) {
  const std::vector<Robot> team = robots(own_sample("patrol.cdl"));
  ASSERT_EQ(team.size(), 1U);
  EXPECT_EQ(team[0].name, "one");
  EXPECT_EQ(team[0].type, "MRV2");
  const Device& base = team[0].actuators.at(0);
  EXPECT_EQ(base.type, "DRIVE");
  EXPECT_EQ(base.binding, "movement");
  const auto& automaton = std::get<Automaton>(base.inputs.at(0).behaviour.form);
  ASSERT_EQ(automaton.states.size(), 3U);
  EXPECT_EQ(automaton.states[0].behaviour.name, "Stop");
  EXPECT_EQ(automaton.states[1].label, "East");
  EXPECT_EQ(automaton.states[1].rules.at(0).trigger.name, "AtGoal");
  EXPECT_EQ(automaton.states[1].rules.at(0).target, "$AN_3");
  EXPECT_EQ(value_of(automaton.states[1].behaviour.parameters, "Goal_Location"),
            Value(std::vector<double>{10, 20.5}));
}

TEST(Resolve, TakesWhatTheDeviceDoesNotSayFromItsBindingPoint) {
  const Device base = robots(own_sample("patrol.cdl")).at(0).actuators.at(0);
  EXPECT_EQ(value_of(base.parameters, "max_vel"), Value(0.5));
  EXPECT_EQ(value_of(base.parameters, "base_vel"), Value(0.2));
}

TEST(Resolve, HandsParametersDown) {
  const Device base = robots(own_sample("learner.cdl")).at(0).actuators.at(0);
  const auto& learner = std::get<Learner>(base.inputs.at(0).behaviour.form);
  const auto& sum = std::get<WeightedSum>(learner.actions.at(0).behaviour.form);
  EXPECT_EQ(value_of(sum.members.at(0).behaviour.parameters, "persistence"), Value(10.0));
  EXPECT_EQ(sum.members[0].weight, Value(0.8));
  EXPECT_EQ(sum.members[1].weight, Value(10.0));
  EXPECT_EQ(value_of(learner.triggers.at(0).behaviour.parameters, "classes"),
            Value(Words{{"Flags"}}));
  EXPECT_EQ(learner.reinforcers.at(0), (Reinforcer{6, 1, 10}));
}

/// What goes on in the only state of the only robot.
Behaviour only_behaviour(const std::string& text) {
  const Device base = robots(text).at(0).actuators.at(0);
  return std::get<Automaton>(base.inputs.at(0).behaviour.form).states.at(0).behaviour;
}

TEST(Resolve, FollowsNamesOfNames) {
  const std::string names = "instGroup a from b;\ninstGroup b from c;\ninstGroup c from [Stop];\n";
  EXPECT_EQ(only_behaviour(names + with_automaton("society[Start] = a")).name, "Stop");
}

TEST(Resolve, FollowsNamesOfDevices) {
  const std::vector<Robot> team = robots(
      "instBP a from b;\ninstBP b from movement(bound_to = base:DRIVE());\n"
      "[vehicle(bound_to = r:MRV2([a]))]");
  ASSERT_EQ(team.size(), 1U);
  EXPECT_EQ(team[0].actuators.at(0).name, "base");
}

TEST(Resolve, EndsWhereNamesGoInACircle) {
  for (const char* text :
       {"instGroup a from a;\n[a]", "instGroup a from [b];\ninstGroup b from a;\n[a]",
        "[vehicle(bound_to = a)]\n\ninstRobot a from a;",
        "instBP a from a;\n[vehicle(bound_to = r:M([a]))]"}) {
    const Findings findings = resolve(parse(text).mission).findings;
    ASSERT_EQ(findings.size(), 1U) << text;
    EXPECT_EQ(findings[0].rule, "too-deep") << text;
  }
}

TEST(Resolve, TakesTheValueOfTheNearestAbove) {
  const std::string items =
      "society[Start] = [%gain = {1}, COOP(members[A] = [%gain = {2}, NOISE(persistence = "
      "{^R %gain})], weight[A] = {^R %gain})]";
  const auto sum = std::get<WeightedSum>(only_behaviour(with_automaton(items)).form);
  EXPECT_EQ(value_of(sum.members.at(0).behaviour.parameters, "persistence"), Value(2.0));
  EXPECT_EQ(sum.members[0].weight, Value(1.0));
}

TEST(Resolve, LeavesAValueThatNothingAboveGives) {
  const Resolved resolved =
      resolve(parse(with_automaton("society[Start] = [%gain = {^}, GoTo]")).mission);
  ASSERT_EQ(resolved.findings.size(), 1U);
  EXPECT_EQ(resolved.findings[0].rule, "nothing-above");
  EXPECT_EQ(
      value_of(only_behaviour(with_automaton("society[Start] = [%gain = {^}, GoTo]")).parameters,
               "gain"),
      Value(FromAbove{}));
}

TEST(Resolve, RefusesWhatIsNoRobot) {
  const Resolved resolved = resolve(parse("[vehicle(bound_to = {1})]").mission);
  EXPECT_TRUE(resolved.robots.empty());
  ASSERT_EQ(resolved.findings.size(), 1U);
  EXPECT_EQ(resolved.findings[0].rule, "no-robot");
}

/// `head`, `count` times `part`, `tail`.
std::string repeated(const std::string& head, const std::string& part, int count,
                     const std::string& tail) {
  std::string text = head;
  for (int i = 0; i < count; ++i) {
    text += part;
  }
  return text + tail;
}

bool is_too_large(const std::string& text) {
  const Findings findings = resolve(parse(text).mission).findings;
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.rule == "too-large"; });
}

TEST(Resolve, BoundsNamesOfLargeListsThatAreFollowedAgainAndAgain) {
  const std::string large = repeated("instGroup a from [", "%p = {1}, ", 50'000, "Stop];\n");
  const std::string text =
      large + repeated("[vehicle(bound_to = r:M([movement(bound_to = b:D(v = COOP(",
                       "members[A] = a, ", 50'000, "w = a)))]))]");
  EXPECT_TRUE(is_too_large(text));
}

TEST(Resolve, BoundsTheSearchForValuesAbove) {
  const std::string text =
      with_automaton(repeated("society[Start] = [", "%p = {1}, ", 50'000, "COOP(") +
                     repeated("", "q = {^}, ", 50'000, "members[A] = NOISE())]"));
  EXPECT_TRUE(is_too_large(text));
}

TEST(Diagram, EscapesLabels) {
  const Box team{"team", "team", true, "", {{"r0", "a\"<&\\;#", false, "", {}, {}}}, {}};
  EXPECT_NE(to_dot(team).find("label=\"a\\\"<&\\\\;#\""), std::string::npos);
  EXPECT_NE(to_mermaid(team).find("\"a#34;#60;#38;#92;#59;#35;\""), std::string::npos);
  EXPECT_NE(to_scxml(team).find("\"a&quot;&lt;&amp;\\;#\""), std::string::npos);
}

TEST(Diagram, HasAnArrowForEachRule) {
  const Box team = diagram_of(robots(own_sample("patrol.cdl")));
  const Box& base = team.inside.at(0).inside.at(0);
  EXPECT_EQ(base.initial, "r0_d0_s0");
  ASSERT_EQ(base.arrows.size(), 3U);
  EXPECT_EQ(base.arrows[2].label, "Detect(Mines or Robots)");
}

TEST(Diagram, HasLabelsInUtf8) {
  const Box team = diagram_of(robots(with_automaton("society[Start]|\xE9\xC3\xA9\x01| = [Stop]")));
  EXPECT_EQ(team.inside.at(0).inside.at(0).inside.at(0).label, "\xC3\xA9\xC3\xA9 : Stop");
}

}  // namespace
}  // namespace tacit::cdl
