#include "idl/cdl/check.h"

#include <gtest/gtest.h>

#include "tests/cdl/samples.h"

namespace tacit::cdl {
namespace {

/// "rule:line, rule:line, …"
std::string found(const std::string& text) {
  std::string all;
  for (const Finding& finding : check_text(text)) {
    all += (all.empty() ? "" : ", ") + finding.rule + ':' + std::to_string(finding.line);
  }
  return all;
}

/// What the finding of that rule says.
std::string said(const std::string& text, const std::string& rule) {
  for (const Finding& finding : check_text(text)) {
    if (finding.rule == rule) {
      return finding.text;
    }
  }
  return "";
}

// The automaton's first line is line 4 of the file.
constexpr const char* kGood =
    "society[Start] = [Stop], society[$B] = [Stop],\nrules[Start] = if [Immediate] goto $B";

TEST(Check, HasNothingToSayOfAGoodMission) {
  EXPECT_EQ(found(with_automaton(kGood)), "");
  EXPECT_EQ(found(own_sample("patrol.cdl")), "");
}

struct Flaw {
  std::string items;
  std::string said;
};

class Flawed : public testing::TestWithParam<Flaw> {};

TEST_P(Flawed, IsFoundWhereItStands) {
  EXPECT_EQ(found(with_automaton(GetParam().items)), GetParam().said);
}

INSTANTIATE_TEST_SUITE_P(
    Automaton, Flawed,
    testing::Values(
        Flaw{"society[A] = [Stop]", "no-start:3"},
        Flaw{"society[Start] = [Stop],\nsociety[Start] = [Stop]", "duplicate-state:5"},
        Flaw{"society[Start] = [Stop],\nrules[B] = if [Immediate] goto Start",
             "rule-of-no-state:5"},
        Flaw{"society[Start] = [Stop],\nrules[Start] = if [Immediate] goto B", "goto-nowhere:5"},
        Flaw{"society[Start] = [Stop],\nsociety[B] = [Stop]", "unreachable-state:5"},
        Flaw{"society[Start] = [AboutFace]", "no-way-out:4"},
        Flaw{"society[Start] = [Stopp],\nrules[Start] = if [Immediate] goto Start",
             "unknown-behaviour:4"},
        Flaw{"society[Start] = [Stop],\nrules[Start] = if [Imediate] goto Start",
             "unknown-trigger:5"},
        Flaw{"society[Start] = [Stop],\nrules[Start] = if [%Delya = {1}, Wait] goto Start",
             "unknown-parameter:5"},
        Flaw{"society[Start] = [Stop],\nrules[Start] = if [%Delay = {Long}, Wait] goto Start",
             "wrong-kind:5"},
        Flaw{"society[Start] = [Stop],\nrules[Start] = if [%Delay = {-1}, Wait] goto Start",
             "out-of-range:5"},
        Flaw{"society[Start] = $AN_7", "undefined-name:4"}));

TEST(Check, HintsAtTheNameThatWasMeant) {
  EXPECT_EQ(said(with_automaton("society[Start] = [Stopp]"), "unknown-behaviour"),
            "the behaviour Stopp is not known, did you mean \"Stop\"?");
}

TEST(Check, FindsASecondStatementOfOneName) {
  EXPECT_EQ(found("instGroup a from [Stop];\ninstGroup a from [Stop];\n" + with_automaton(kGood)),
            "duplicate-name:2");
}

TEST(Check, FindsNamesInACircle) {
  EXPECT_EQ(found("instGroup a from [b];\ninstGroup b from [a];\n" + with_automaton(kGood)),
            "circle:2");
}

TEST(Check, FollowsLongChainsOfNames) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) {
    text += "instGroup a" + std::to_string(i) + " from [a" + std::to_string(i + 1) + "];\n";
  }
  EXPECT_EQ(found(text + "instGroup a100000 from [Stop];\n[vehicle(bound_to = a0)]"),
            "no-robots:1, too-deep:200");
}

TEST(Check, BoundsReferencesToReferences) {
  std::string text;
  for (int i = 0; i < 60; ++i) {
    const std::string next = "$" + std::to_string(i + 1);
    text += "instGroup $" + std::to_string(i) + " from [" + next + ", " + next + "];\n";
  }
  text += "instGroup $60 from [Stop];\n[$0]";
  EXPECT_NE(found(text).find("too-large"), std::string::npos);
}

TEST(Check, FindsARobotWithoutActuators) {
  EXPECT_EQ(found("[\nvehicle(bound_to = r:MRV2())]"), "no-actuators:2");
}

TEST(Check, FindsAFileWithoutRobots) { EXPECT_EQ(found("bindArch A;"), "no-robots:1"); }

}  // namespace
}  // namespace tacit::cdl
