#include <gtest/gtest.h>

#include <chrono>

#include "idl/cdl/check.h"
#include "tests/cdl/large_mission.h"
#include "tests/cdl/laws.h"
#include "tests/cdl/missionlab_samples.h"
#include "tests/cdl/samples.h"

namespace tacit::cdl {
namespace {

std::vector<std::string> own_samples() {
  return {own_sample("patrol.cdl"), own_sample("learner.cdl")};
}

/// The team of a sample without what is kept as text.
std::string statements_of_patrol() {
  const std::string text = own_sample("patrol.cdl");
  return text.substr(text.find("instGroup"));
}

TEST(BadInput, CutOffAnywhereKeepsTheLaws) {
  for (const std::string& text : own_samples()) {
    for (std::size_t end = 0; end <= text.size(); ++end) {
      ASSERT_EQ(broken_law(text.substr(0, end)), "") << text.substr(0, end);
      (void)check_text(text.substr(0, end));
    }
  }
}

TEST(BadInput, CutOffInAStatementIsAnError) {
  const std::string text =
      "instBP<1,2> |w| $A from movement(v = FSA(society[S] = [%a = {1}, Stop]));";
  for (std::size_t end = 1; end < text.size(); ++end) {
    EXPECT_FALSE(parse(text.substr(0, end)).findings.empty()) << text.substr(0, end);
  }
}

TEST(BadInput, CutOffMissionsOfMissionLabKeepTheLaws) {
  constexpr std::size_t kStep = 97;
  for (const SampleFile& sample : missionlab_samples()) {
    for (std::size_t end = 0; end < sample.text.size(); end += kStep) {
      ASSERT_EQ(broken_law(sample.text.substr(0, end)), "") << sample.name << " to " << end;
    }
  }
}

TEST(BadInput, ABracketTooFewIsAnError) {
  const std::string text = statements_of_patrol();
  for (std::size_t at = text.find_first_of("[]()"); at != std::string::npos;
       at = text.find_first_of("[]()", at + 1)) {
    std::string broken = text;
    broken.erase(at, 1);
    EXPECT_FALSE(parse(broken).findings.empty()) << broken;
  }
}

TEST(BadInput, ABracketTooManyIsAnError) {
  const std::string text = statements_of_patrol();
  for (std::size_t at = text.find_first_of("[]()"); at != std::string::npos;
       at = text.find_first_of("[]()", at + 1)) {
    std::string broken = text;
    broken.insert(at, 1, text[at]);
    EXPECT_FALSE(parse(broken).findings.empty()) << broken;
  }
}

TEST(BadInput, ANulByteIsAnErrorWhereverItStands) {
  const std::string text = own_sample("patrol.cdl");
  for (std::size_t at = 0; at <= text.size(); ++at) {
    std::string broken = text;
    broken.insert(at, 1, '\0');
    EXPECT_FALSE(parse(broken).findings.empty()) << at;
  }
}

TEST(BadInput, AnyByteAnywhereKeepsTheLaws) {
  for (const std::string& text : own_samples()) {
    for (std::size_t at = 0; at < text.size(); ++at) {
      for (const char byte : {'\xE9', '\x80', '\xFF', '\r', '\x1B', '}'}) {
        std::string changed = text;
        changed[at] = byte;
        ASSERT_EQ(broken_law(changed), "") << changed;
      }
    }
  }
}

TEST(BadInput, LinesMayEndInCarriageReturns) {
  std::string text;
  for (const char letter : own_sample("patrol.cdl")) {
    text += letter == '\n' ? "\r\n" : std::string(1, letter);
  }
  EXPECT_TRUE(check_text(text).empty());
  EXPECT_EQ(broken_law(text), "");
}

TEST(BadInput, AByteOrderMarkIsPassedOver) {
  const std::string text = "\xEF\xBB\xBF" + own_sample("patrol.cdl");
  EXPECT_TRUE(parse(text).findings.empty());
  EXPECT_EQ(broken_law(text), "");
  EXPECT_FALSE(parse("[a] \xEF\xBB\xBF").findings.empty());
}

TEST(BadInput, ManyFindingsAreCutShort) {
  std::string text;
  for (int i = 0; i < 5000; ++i) {
    text += "instGroup $A from [$B, Hum];\n";
  }
  std::size_t too_many = 0;
  const Findings findings = check_text(text + "[$A]");
  for (const Finding& finding : findings) {
    too_many += finding.rule == "too-many" ? 1 : 0;
  }
  EXPECT_EQ(too_many, 2U);
  EXPECT_LE(findings.size(), 2 * kMostFindings + 5);
}

TEST(BadInput, LongNamesThatAreAlmostRightTakeNoTime) {
  std::string text =
      "[vehicle(bound_to = r:M([movement(bound_to = b:D(v = FSA(society[Start] = [Stop]";
  for (char end = 'a'; end <= 'z'; ++end) {
    const std::string name = std::string(100'000, 'x') + end;
    text += ", society[" + name + "] = [Stop], rules[Start] = if [" + name + "] goto " + name + "x";
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(check_text(text + ")))]))]").empty());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

double seconds_to_check(const std::string& text) {
  double best = 1e9;
  for (int i = 0; i < 3; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const Findings findings = check_text(text);
    EXPECT_TRUE(findings.empty()) << findings.front().text;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    best = std::min(best, taken.count());
  }
  return best;
}

// In quadratic time eight times the text would take 64 times as long.
TEST(LargeFiles, TakeTimeInProportion) {
  constexpr std::size_t kMegabyte = 1'000'000;
  EXPECT_LT(seconds_to_check(large_mission(8 * kMegabyte)),
            24 * seconds_to_check(large_mission(kMegabyte)));
}

TEST(LargeFiles, MayHaveOneAutomatonWithManyStates) {
  constexpr std::size_t kStates = 4000;
  EXPECT_LT(seconds_to_check(large_mission(1, 8 * kStates)),
            24 * seconds_to_check(large_mission(1, kStates)));
}

}  // namespace
}  // namespace tacit::cdl
