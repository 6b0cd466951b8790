#include "world_server/app/roster.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

const std::string kDigest(64, 'a');

Hello hello(std::uint16_t robot, std::uint64_t incarnation) {
  return {{robot}, incarnation, 42, "here", "1.0", "lm", "sim", kDigest};
}

class Rosters : public testing::Test {
 protected:
  Order refusal(const Hello& hello) {
    const Order order = roster_.admit(hello);
    EXPECT_EQ(order.kind, OrderKind::Refuse);
    return order;
  }

  Roster roster_{{3, "1.0", kDigest}};
};

TEST_F(Rosters, WelcomeTheAgentOfAFreeRobot) {
  const Order order = roster_.admit(hello(2, 7));
  EXPECT_EQ(order.kind, OrderKind::Welcome);
  EXPECT_EQ(order.robot.value, 2);
  EXPECT_EQ(order.incarnation, 7U);
}

TEST_F(Rosters, WelcomeTheSameAgentAgain) {
  (void)roster_.admit(hello(2, 7));
  EXPECT_EQ(roster_.admit(hello(2, 7)).kind, OrderKind::Welcome);
}

TEST_F(Rosters, RefuseASecondAgentOfOneRobotAndNameTheFirst) {
  (void)roster_.admit(hello(2, 7));
  const Order order = refusal(hello(2, 8));
  EXPECT_EQ(order.incarnation, 8U);
  EXPECT_NE(order.reason.find("process 42 on here"), std::string::npos) << order.reason;
}

TEST_F(Rosters, LeaveTheFirstAgentItsSeat) {
  (void)roster_.admit(hello(2, 7));
  (void)roster_.admit(hello(2, 8));
  EXPECT_EQ(roster_.agent_of({2})->incarnation, 7U);
}

TEST_F(Rosters, WelcomeANewAgentOnceTheOldOneIsDismissed) {
  (void)roster_.admit(hello(2, 7));
  roster_.dismiss({2});
  EXPECT_EQ(roster_.admit(hello(2, 8)).kind, OrderKind::Welcome);
}

TEST_F(Rosters, RefuseARobotThatIsNotInTheScenario) {
  EXPECT_NE(refusal(hello(4, 1)).reason.find("robots 1 to 3"), std::string::npos);
  (void)refusal(hello(0, 1));
}

TEST_F(Rosters, RefuseAnotherScenarioAndSayBothDigests) {
  Hello other = hello(1, 1);
  other.scenario_digest = std::string(64, 'b');
  const std::string reason = refusal(other).reason;
  EXPECT_NE(reason.find(kDigest), std::string::npos);
  EXPECT_NE(reason.find(other.scenario_digest), std::string::npos);
}

TEST_F(Rosters, RefuseAnotherVersion) {
  Hello other = hello(1, 1);
  other.version = "0.9";
  EXPECT_NE(refusal(other).reason.find("0.9"), std::string::npos);
}

}  // namespace
}  // namespace tacit
