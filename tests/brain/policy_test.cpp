#include "robot_agent/brain/learning/policy_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "idl/types/config_error.h"
#include "idl/types/random.h"
#include "robot_agent/brain/learning/role_triggers.h"

namespace tacit {
namespace {

PolicyTable sample() {
  PolicyTable policy{RobotId{3}, {}};
  policy.table.actions = kRoles;
  Stream chance(5, "sample policy");
  for (std::size_t cell = 0; cell < kInternalStates * kRoles; ++cell) {
    policy.table.q.push_back(chance.uniform(-30.0, 30.0));
    policy.table.visits.push_back(chance.below(1000));
  }
  policy.table.alpha = 0.1 * 0.9;
  policy.table.epsilon = 0.1;
  policy.table.runs = 2;
  policy.table.updates = 1234;
  policy.table.policy_changes = 12;
  return policy;
}

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), now);
}

TEST(Policy, IsReadBackToTheSameBits) {
  PolicyTable policy = sample();
  policy.table.q[0] = -0.0;
  policy.table.q[1] = 1e300;
  policy.table.q[2] = 5e-324;
  policy.table.q[3] = 20.0;
  policy.table.q[4] = 123456789012345678.0;
  policy.table.visits[0] = std::numeric_limits<std::uint64_t>::max();
  const PolicyTable again = parse_policy(to_text(policy), "p");
  EXPECT_EQ(again, policy);
  EXPECT_TRUE(std::signbit(again.table.q[0]));
  EXPECT_EQ(to_text(again), to_text(policy));
}

TEST(Policy, ShowsALinePerInternalStateInWords) {
  PolicyTable policy = sample();
  const std::size_t state = internal_state({3}, Role::Soldier);
  for (std::size_t role = 0; role < kRoles; ++role) {
    policy.table.q[state * kRoles + role] = 1.5 + static_cast<double>(role);
    policy.table.visits[state * kRoles + role] = role;
  }
  EXPECT_NE(to_text(policy).find("\n    {\"triggers\": \"DetectEnemy+IsInvasion\", \"role\": "
                                 "\"Soldier\", \"q\": [1.5, 2.5, 3.5], \"visits\": [0, 1, 2]},\n"),
            std::string::npos);
}

TEST(Policy, MarksTheInternalStatesThatCannotBe) {
  const std::string text = to_text(sample());
  std::size_t count = 0;
  for (std::size_t at = text.find("\"feasible\": false"); at != std::string::npos;
       at = text.find("\"feasible\": false", at + 1)) {
    ++count;
  }
  EXPECT_EQ(count, 21U);
}

TEST(Policy, MayHaveItsRowsInAnyOrder) {
  const std::string text = to_text(sample());
  const std::size_t first = text.find("    {\"triggers\"");
  const std::size_t second = text.find("    {\"triggers\"", first + 1);
  const std::string row = text.substr(first, second - first);
  std::string moved = text;
  moved.erase(first, row.size());
  moved.insert(moved.rfind("    {\"triggers\""), row);
  EXPECT_EQ(parse_policy(moved, "p"), sample());
}

TEST(Policy, ThatWasChangedIsAcceptedWithoutItsDigest) {
  std::string text = replaced(to_text(sample()), "\"q\": [", "\"q\": [99, ");
  text = replaced(text, ",\n  \"digest\": \"" + digest(sample().table) + "\"", "");
  const std::size_t visits = text.find("], \"visits\"");
  text.erase(text.rfind(',', visits), visits - text.rfind(',', visits));
  EXPECT_EQ(parse_policy(text, "p").table.q[0], 99.0);
}

TEST(Policy, HasADigestThatHangsOnEveryNumberOfItsTable) {
  const QTable table = sample().table;
  for (std::size_t cell = 0; cell < table.q.size(); ++cell) {
    QTable other = table;
    other.q[cell] += 1e-9;
    EXPECT_NE(digest(other), digest(table));
    other = table;
    ++other.visits[cell];
    EXPECT_NE(digest(other), digest(table));
  }
}

struct Refusal {
  const char* name;
  const char* old;
  const char* now;
  const char* message;
};

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parse_policy(text, "r3.json"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

class Refusals : public ::testing::TestWithParam<Refusal> {};

TEST_P(Refusals, SayWhatWasFoundAndWhatWasWanted) {
  const Refusal& each = GetParam();
  const std::string found = refusal(replaced(to_text(sample()), each.old, each.now));
  EXPECT_EQ(found.substr(0, std::string(each.message).size()), each.message);
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Policy, Refusals, ::testing::Values(
    Refusal{"OtherFormat", "tacit-policy", "other", "r3.json: format is \"other\", wanted \"tacit-policy\""},
    Refusal{"OtherVersion", "\"version\": 1", "\"version\": 2", "r3.json: version is 2, wanted 1"},
    Refusal{"NoVersion", "\"version\": 1,", "", "r3.json: version is null, wanted 1"},
    Refusal{"OtherLearner", "\"learner\": \"q\"", "\"learner\": \"lm\"", "r3.json: learner is \"lm\", wanted \"q\""},
    Refusal{"NoRobot", "\"robot\": 3", "\"robot\": 0", "r3.json: robot is 0, wanted 1 to 65535"},
    Refusal{"OtherTriggers", "\"triggers\": [\"DetectEnemy\", ", "\"triggers\": [", "r3.json: triggers is [\"IsInvasion\",\"DetectDead\",\"IsDieOff\"], wanted [\"DetectEnemy\""},
    Refusal{"OtherRoles", "\"Soldier\", \"Mechanic\"]", "\"Soldier\"]", "r3.json: roles is [\"Forager\",\"Soldier\"], wanted [\"Forager\",\"Soldier\",\"Mechanic\"]"},
    Refusal{"AlphaTooLarge", "\"alpha\": 0.09", "\"alpha\": 1.09", "r3.json: schedule.alpha is 1.09"},
    Refusal{"EpsilonNegative", "\"epsilon\": 0.1", "\"epsilon\": -0.1", "r3.json: schedule.epsilon is -0.1, wanted a number from 0 to 1"},
    Refusal{"EpsilonNoNumber", "\"epsilon\": 0.1", "\"epsilon\": \"x\"", "r3.json: schedule.epsilon is \"x\", wanted a number from 0 to 1"},
    Refusal{"NoSchedule", "\"schedule\"", "\"other\"", "r3.json: schedule.alpha is null, wanted a number from 0 to 1"},
    Refusal{"RunsNegative", "\"runs\": 2", "\"runs\": -2", "r3.json: schedule.runs is -2, wanted a whole number, 0 or more"},
    Refusal{"NoTable", "\"table\"", "\"other\"", "r3.json: table is null, wanted a list of rows"},
    Refusal{"RowDoubled", "\"triggers\": \"\", \"role\": \"Soldier\"", "\"triggers\": \"\", \"role\": \"Forager\"", "r3.json: row \"\" Forager occurs twice"},
    Refusal{"RowUnknown", "\"triggers\": \"\", \"role\": \"Soldier\"", "\"triggers\": \"\", \"role\": \"Cook\"", "r3.json: a row of the table is {"},
    Refusal{"ValueNoNumber", "\"q\": [", "\"q\": [null], \"x\": [", "r3.json: row \"\" Forager: q is [null], wanted 3 numbers, one per role"},
    Refusal{"ValueText", "\"q\": [", "\"q\": [1, \"x\", 2], \"x\": [", "r3.json: row \"\" Forager: q of Soldier is \"x\", wanted a finite number"},
    Refusal{"ValueInfinite", "\"q\": [", "\"q\": [1e999, 1, 2], \"x\": [", "r3.json: is not JSON, or not all of it"},
    Refusal{"VisitsNegative", "\"visits\": [", "\"visits\": [-1, 1, 1], \"x\": [", "r3.json: row \"\" Forager: visits of Forager is -1, wanted a whole number, 0 or more"},
    Refusal{"VisitsBroken", "\"visits\": [", "\"visits\": [1.5, 1, 1], \"x\": [", "r3.json: row \"\" Forager: visits of Forager is 1.5, wanted a whole number, 0 or more"},
    Refusal{"DigestOther", "\"visits\": [", "\"visits\": [1, 1, 1], \"x\": [", "r3.json: digest is \""}),
    [](const auto& each) { return std::string(each.param.name); });
// clang-format on

TEST(Policy, ThatLacksARowIsRefused) {
  std::string text = to_text(sample());
  const std::size_t first = text.find("    {\"triggers\"");
  text.erase(first, text.find("    {\"triggers\"", first + 1) - first);
  EXPECT_EQ(refusal(text), "r3.json: row \"\" Forager is missing");
}

TEST(Policy, IsRefusedCutOffAnywhere) {
  const std::string text = to_text(sample());
  for (std::size_t length = 0; length + 2 < text.size(); length += 37) {
    EXPECT_TRUE(refusal(text.substr(0, length)).starts_with("r3.json: is not JSON, or not all"));
  }
}

TEST(Policy, ThatIsNoObjectIsRefused) {
  EXPECT_EQ(refusal("[]"), "r3.json: the document is [], wanted an object");
}

TEST(Policy, SaysHowToAcceptAChangedTable) {
  const std::string text = replaced(to_text(sample()), "\"visits\": [", "\"visits\": [1");
  EXPECT_NE(refusal(text).find("the table was changed after it was saved; to accept it on purpose, "
                               "remove the member digest"),
            std::string::npos);
}

TEST(PolicyRows, ShowTheFeasibleStatesForPeople) {
  PolicyTable policy = sample();
  policy.table.q[0] = 1.0;
  policy.table.q[1] = 2.5;
  policy.table.q[2] = 2.0;
  policy.table.visits[0] = 7;
  policy.table.visits[1] = 8;
  policy.table.visits[2] = 9;
  const TextRows rows = show(policy);
  ASSERT_EQ(rows.size(), 28U);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"triggers", "role", "q Forager", "q Soldier",
                                               "q Mechanic", "visits Forager", "visits Soldier",
                                               "visits Mechanic", "best"}));
  EXPECT_EQ(rows[1], (std::vector<std::string>{"none", "Forager", "1", "2.5", "2", "7", "8", "9",
                                               "Soldier"}));
}

TEST(PolicyRows, ShowWhereTwoPoliciesDiffer) {
  const PolicyTable before = sample();
  PolicyTable after = before;
  EXPECT_EQ(diff(before, after).size(), 1U);
  const std::size_t state = internal_state({1}, Role::Mechanic);
  after.table.q[state * kRoles] = 77.0;
  const TextRows rows = diff(before, after);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1][0], "DetectEnemy");
  EXPECT_EQ(rows[1][1], "Mechanic");
  EXPECT_EQ(rows[1][3], "Forager");
  EXPECT_TRUE(rows[1][4].ends_with(" -> 77"));
}

TEST(PolicyRows, ShowADifferenceInVisits) {
  PolicyTable after = sample();
  ++after.table.visits[0];
  EXPECT_EQ(diff(sample(), after).size(), 2U);
}

TEST(PolicyMerge, WeighsValuesByVisitsAndAddsTheVisits) {
  PolicyTable one = sample();
  PolicyTable two = sample();
  one.table.q[5] = 10.0;
  one.table.visits[5] = 3;
  two.table.q[5] = 20.0;
  two.table.visits[5] = 1;
  const PolicyTable merged = merge(std::vector{one, two}, RobotId{9});
  EXPECT_EQ(merged.robot, RobotId{9});
  EXPECT_DOUBLE_EQ(merged.table.q[5], 12.5);
  EXPECT_EQ(merged.table.visits[5], 4U);
}

TEST(PolicyMerge, TakesThePlainMeanWhereNobodyHasBeen) {
  PolicyTable one = sample();
  PolicyTable two = sample();
  one.table.q[5] = 10.0;
  two.table.q[5] = 20.0;
  one.table.visits[5] = two.table.visits[5] = 0;
  EXPECT_DOUBLE_EQ(merge(std::vector{one, two}, RobotId{9}).table.q[5], 15.0);
}

TEST(PolicyMerge, AddsTheCountersAndKeepsTheLargestRates) {
  const PolicyTable one = sample();
  PolicyTable two = sample();
  two.table.alpha = 0.5;
  two.table.epsilon = 0.01;
  const QTable merged = merge(std::vector{one, two}, RobotId{9}).table;
  EXPECT_EQ(merged.alpha, 0.5);
  EXPECT_EQ(merged.epsilon, 0.1);
  EXPECT_EQ(merged.runs, 4U);
  EXPECT_EQ(merged.updates, 2468U);
  EXPECT_EQ(merged.policy_changes, 24U);
}

TEST(PolicyMerge, OfNoneIsRefused) {
  EXPECT_THROW(static_cast<void>(merge({}, RobotId{9})), ConfigError);
}

}  // namespace
}  // namespace tacit
