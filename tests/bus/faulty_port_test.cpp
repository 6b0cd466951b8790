#include <gtest/gtest.h>

#include <deque>
#include <map>

#include "idl/types/random.h"
#include "robot_agent/app/answers.h"
#include "world_server/app/exchange.h"

namespace tacit {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kRobots = 4;
constexpr Tick kTicks = 300;

/// How bad the way between world and agents is; each a chance per message.
struct Faults {
  double loss = 0.0;
  double doubling = 0.0;
  double overtaking = 0.0;
};

/// Messages under way, in both directions, as an unreliable network treats them.
template <class Word>
class Way {
 public:
  Way(Faults faults, Stream& chance) : faults_(faults), chance_(chance) {}

  void put(const Word& word) {
    if (chance_.uniform() < faults_.loss) return;
    under_way_.push_back(word);
    if (chance_.uniform() < faults_.doubling) under_way_.push_back(word);
  }
  /// Some of what is under way arrives; the rest takes longer.
  std::vector<Word> arrivals() {
    std::vector<Word> out;
    std::deque<Word> late;
    for (Word& word : under_way_) {
      if (chance_.uniform() < faults_.overtaking) {
        late.push_back(word);
      } else {
        out.push_back(word);
      }
    }
    under_way_ = std::move(late);
    return out;
  }

 private:
  Faults faults_;
  Stream& chance_;
  std::deque<Word> under_way_;
};

/// A decision that depends on all that its robot was asked so far, so that one asked twice, never
/// or out of turn shows in every later command.
Answers::Decide remembering() {
  return [sum = 0.0](const Percept& percept) mutable {
    sum = 0.5 * sum + static_cast<double>(percept.tick + percept.robot.value);
    Command command;
    command.robot = percept.robot;
    command.tick = percept.tick;
    command.turn_radps = sum;
    return command;
  };
}

class FaultyPort final : public AgentPort {
 public:
  void forget(RobotId /*robot*/) override {}
  FaultyPort(Faults faults, std::uint64_t seed)
      : chance_(seed, "faults"), percepts_(faults, chance_), commands_(faults, chance_) {}

  /// One more agent process that claims the robot.
  void add_agent(std::uint16_t robot) { agents_.emplace(RobotId{robot}, Answers(remembering())); }

  void send(const Percept& percept) override { percepts_.put(percept); }
  void send(const Order&) override {}
  [[nodiscard]] bool connected(RobotId) const override { return true; }

  /// Lets agents answer what arrives and hands `barrier` what comes back.
  void move_on(Barrier& barrier) {
    for (const Percept& percept : percepts_.arrivals()) {
      const auto [first, last] = agents_.equal_range(percept.robot);
      for (auto agent = first; agent != last; ++agent) {
        if (const Command* command = agent->second.to(percept)) commands_.put(*command);
      }
    }
    for (const Command& command : commands_.arrivals()) barrier.put(command);
  }

 private:
  Stream chance_;
  Way<Percept> percepts_;
  Way<Command> commands_;
  std::multimap<RobotId, Answers> agents_;
};

std::vector<Percept> percepts_at(Tick tick) {
  std::vector<Percept> percepts(kRobots);
  for (std::size_t i = 0; i < kRobots; ++i) {
    percepts[i].robot = {static_cast<std::uint16_t>(i + 1)};
    percepts[i].tick = tick;
  }
  return percepts;
}

struct History {
  std::vector<double> turns;
  std::uint32_t resent = 0;
  milliseconds longest_tick{0};
};

/// Makes a run and notes every command of it in order.
History run(FaultyPort& port) {
  Barrier barrier(kRobots, [] {});
  Exchange exchange(port, barrier);
  History history;
  Exchange::Time now{};
  for (Tick tick = 0; tick < kTicks; ++tick) {
    const Exchange::Time begun = now;
    const std::vector<Percept> percepts = percepts_at(tick);
    exchange.begin(percepts, std::vector<bool>(kRobots, true), now);
    while (!exchange.complete() && now - begun < std::chrono::minutes(10)) {
      port.move_on(barrier);
      now += milliseconds(1);
      exchange.resend_if_due(now);
    }
    for (const Command& command : exchange.end()) history.turns.push_back(command.turn_radps);
    history.longest_tick =
        std::max(history.longest_tick, std::chrono::duration_cast<milliseconds>(now - begun));
  }
  history.resent = exchange.resent();
  return history;
}

History run_with(Faults faults, std::uint64_t seed) {
  FaultyPort port(faults, seed);
  for (std::uint16_t robot = 1; robot <= kRobots; ++robot) port.add_agent(robot);
  return run(port);
}

class FaultyPorts : public testing::TestWithParam<std::uint64_t> {};

TEST_P(FaultyPorts, ThatLoseMessagesDoNotChangeTheRun) {
  const History history = run_with({0.3, 0.0, 0.0}, GetParam());
  EXPECT_EQ(history.turns, run_with({}, 1).turns);
  EXPECT_GT(history.resent, 0U);
  EXPECT_LT(history.longest_tick, std::chrono::seconds(30));
}

TEST_P(FaultyPorts, ThatDoubleMessagesDoNotChangeTheRun) {
  EXPECT_EQ(run_with({0.0, 0.5, 0.0}, GetParam()).turns, run_with({}, 1).turns);
}

TEST_P(FaultyPorts, ThatReorderMessagesDoNotChangeTheRun) {
  EXPECT_EQ(run_with({0.0, 0.3, 0.5}, GetParam()).turns, run_with({}, 1).turns);
}

TEST_P(FaultyPorts, OfAllKindsAtOnceDoNotChangeTheRun) {
  EXPECT_EQ(run_with({0.3, 0.3, 0.3}, GetParam()).turns, run_with({}, 1).turns);
}

TEST_P(FaultyPorts, WithTwoAgentsOfOneRobotStillGiveOneCommandForEachTick) {
  FaultyPort port({0.1, 0.1, 0.1}, GetParam());
  for (std::uint16_t robot = 1; robot <= kRobots; ++robot) port.add_agent(robot);
  port.add_agent(2);
  EXPECT_EQ(run(port).turns.size(), kRobots * kTicks);
}

INSTANTIATE_TEST_SUITE_P(Seeds, FaultyPorts, testing::Range<std::uint64_t>(1, 11));

TEST(Exchange, DoesNotSendAgainWhatIsAnsweredInTime) { EXPECT_EQ(run_with({}, 1).resent, 0U); }

TEST(Exchange, SendsAgainEverMoreRarely) {
  FaultyPort port({}, 1);  // Without agents nobody answers.
  Barrier barrier(kRobots, [] {});
  Exchange exchange(port, barrier);
  const std::vector<Percept> percepts = percepts_at(0);
  Exchange::Time now{};
  exchange.begin(percepts, std::vector<bool>(kRobots, true), now);
  std::vector<Exchange::Time> sent;
  for (int i = 0; i < 8; ++i) {
    sent.push_back(exchange.resend_at());
    exchange.resend_if_due(exchange.resend_at());
  }
  EXPECT_EQ(sent[0] - now, Exchange::kFirstResend);
  EXPECT_EQ(sent[2] - sent[1], 2 * (sent[1] - sent[0]));
  EXPECT_EQ(sent[7] - sent[6], Exchange::kLongestPause);
}

TEST(Exchange, SendsAgainToNobodyWhoHasAnswered) {
  FaultyPort port({}, 1);
  port.add_agent(1);
  Barrier barrier(kRobots, [] {});
  Exchange exchange(port, barrier);
  const std::vector<Percept> percepts = percepts_at(0);
  exchange.begin(percepts, std::vector<bool>(kRobots, true), {});
  port.move_on(barrier);
  exchange.resend_if_due(exchange.resend_at());
  EXPECT_EQ(exchange.resent(), kRobots - 1);
}

TEST(Exchange, SendsNothingToAbsentRobots) {
  FaultyPort port({}, 1);
  for (std::uint16_t robot = 1; robot <= kRobots; ++robot) port.add_agent(robot);
  Barrier barrier(kRobots, [] {});
  Exchange exchange(port, barrier);
  const std::vector<Percept> percepts = percepts_at(0);
  exchange.begin(percepts, {true, false, true, false}, {});
  port.move_on(barrier);
  EXPECT_TRUE(exchange.complete());
  EXPECT_EQ(exchange.end().size(), 2U);
}

}  // namespace
}  // namespace tacit
