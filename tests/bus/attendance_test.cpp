#include "world_server/app/attendance.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "idl/bus/host_name.h"

namespace tacit {
namespace {

const std::string kDigest(64, 'a');

struct RecordingPort final : AgentPort {
  void send(const Percept&) override {}
  void send(const Order& order) override { orders.push_back(order); }
  [[nodiscard]] bool connected(RobotId robot) const override { return wired.contains(robot); }
  void forget(RobotId robot) override { forgotten.push_back(robot); }

  std::vector<Order> orders;
  std::vector<RobotId> forgotten;
  std::set<RobotId> wired{{1}, {2}};
};

class Attendances : public testing::Test {
 protected:
  ~Attendances() override {
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }

  /// An agent process and what it says.
  Hello start_agent(std::uint16_t robot, std::uint64_t incarnation) {
    const pid_t child = fork();
    if (child == 0) {
      for (;;) pause();
    }
    children_.push_back(child);
    return {{robot}, incarnation, child, host_name(), "1.0", "lm", "sim", kDigest};
  }
  void kill_agent(const Hello& hello) {
    kill(hello.pid, SIGKILL);
    siginfo_t info{};
    waitid(P_PID, static_cast<id_t>(hello.pid), &info, WEXITED | WNOWAIT);
  }

  RecordingPort port_;
  Attendance attendance_{{2, "1.0", kDigest}, port_};
  std::vector<pid_t> children_;
};

using Happenings = std::vector<Happening>;

TEST_F(Attendances, CountAnAgentOnceItIsWelcomeAndConnected) {
  port_.wired.clear();
  (void)attendance_.hear(start_agent(1, 5));
  EXPECT_EQ(attendance_.look(), Happenings{});
  port_.wired.insert({1});
  EXPECT_EQ(attendance_.look(), Happenings{RobotBack{{1}}});
  EXPECT_EQ(attendance_.present(), (std::vector<bool>{true, false}));
  EXPECT_EQ(attendance_.absent(), "2");
}

TEST_F(Attendances, TellOfEachChangeOnce) {
  (void)attendance_.hear(start_agent(1, 5));
  EXPECT_EQ(attendance_.look().size(), 1U);
  EXPECT_EQ(attendance_.look(), Happenings{});
}

TEST_F(Attendances, LoseAKilledAgent) {
  const Hello agent = start_agent(1, 5);
  (void)attendance_.hear(agent);
  (void)attendance_.look();
  kill_agent(agent);
  EXPECT_EQ(attendance_.look(), Happenings{RobotLost{{1}}});
  EXPECT_EQ(attendance_.count(), 0U);
  EXPECT_EQ(port_.forgotten, std::vector<RobotId>{{1}});
}

TEST_F(Attendances, LoseAnAgentOfAnotherHostWhoseConnectionBroke) {
  Hello agent = start_agent(1, 5);
  agent.host = "elsewhere";
  (void)attendance_.hear(agent);
  (void)attendance_.look();
  port_.wired.erase({1});
  EXPECT_EQ(attendance_.look(), Happenings{RobotLost{{1}}});
}

TEST_F(Attendances, LetARestartedAgentInBeforeTheEndOfTheOldOneWasSeen) {
  const Hello agent = start_agent(1, 5);
  (void)attendance_.hear(agent);
  (void)attendance_.look();
  kill_agent(agent);
  EXPECT_EQ(attendance_.hear(start_agent(1, 6)), Happenings{RobotLost{{1}}});
  EXPECT_EQ(port_.orders.back().kind, OrderKind::Welcome);
  EXPECT_EQ(attendance_.look(), Happenings{RobotBack{{1}}});
}

TEST_F(Attendances, RefuseTheSecondOfTwoLivingAgents) {
  (void)attendance_.hear(start_agent(1, 5));
  (void)attendance_.look();
  EXPECT_EQ(attendance_.hear(start_agent(1, 6)), Happenings{});
  EXPECT_EQ(port_.orders.back().kind, OrderKind::Refuse);
  EXPECT_EQ(port_.orders.back().incarnation, 6U);
  EXPECT_EQ(attendance_.count(), 1U);
}

TEST_F(Attendances, AnswerAnAgentOfNoRobotOfTheScenario) {
  (void)attendance_.hear(start_agent(9, 5));
  ASSERT_EQ(port_.orders.size(), 1U);
  EXPECT_EQ(port_.orders[0].kind, OrderKind::Refuse);
  EXPECT_EQ(attendance_.look(), Happenings{});
}

}  // namespace
}  // namespace tacit
