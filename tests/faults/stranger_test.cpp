#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "idl/bus/participant.h"
#include "idl/bus/publisher.h"
#include "tests/faults/live_run.h"

namespace tacit {
namespace {

using nlohmann::json;

/// Somebody on the run's domain who writes commands that nobody asked for.
class Stranger {
 public:
  Stranger(const LiveRun& run, RobotId posing_as)
      : participant_(Identity{Party::Agent, posing_as, run.domain(), run.run_nonce(), 999}),
        commands_(participant_, posing_as) {}

  [[nodiscard]] bool is_heard() {
    return becomes_true([this] { return commands_.readers() > 0; });
  }
  void send(const Command& command, int times = 50) {
    for (int i = 0; i < times; ++i) {
      commands_.publish(command);
    }
  }

 private:
  Participant participant_;
  Publisher<topics::Command> commands_;
};

void expect_undisturbed(LiveRun& run) {
  const Finished finished = run.launcher().finish();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const json summary = json::parse(finished.out);
  EXPECT_EQ(summary["repeatable"], true);
  EXPECT_EQ(summary["event_log_sha256"], undisturbed_sha256());
}

TEST(MalformedSample, IsDroppedCountedAndChangesNothing) {
  LiveRun run;
  {
    Stranger stranger(run, {2});
    ASSERT_TRUE(stranger.is_heard());
    stranger.send({{2}, 100, {std::numeric_limits<double>::quiet_NaN(), 0.0}, 0.0});
    EXPECT_TRUE(becomes_true([&run] {
      return text_of(run.directory() / "logs/world_server.log").find("refused") !=
             std::string::npos;
    }));
  }
  expect_undisturbed(run);
}

TEST(CommandOfARobotThatIsNotOnTheRoster, ChangesNothing) {
  LiveRun run;
  {
    Stranger stranger(run, {2});
    ASSERT_TRUE(stranger.is_heard());
    stranger.send({{77}, 100, {1.0, 0.0}, 0.0});
  }
  expect_undisturbed(run);
}

TEST(CommandOfAnotherTick, ChangesNothing) {
  LiveRun run;
  {
    Stranger stranger(run, {2});
    ASSERT_TRUE(stranger.is_heard());
    stranger.send({{2}, 1, {1.0, 0.0}, 0.0});
    stranger.send({{2}, 1000000, {1.0, 0.0}, 0.0});
  }
  expect_undisturbed(run);
}

TEST(SecondAgentOfOneRobot, IsRefusedWithTwoAndChangesNothing) {
  LiveRun run;
  const Scratch scratch;
  std::vector<std::string> words = LiveRun::words_of(run.agent(3));
  words.back() = scratch / "memory";
  const Finished second = Running(words).finish();
  EXPECT_EQ(second.exit_code, 2) << second.err;
  EXPECT_NE(second.err.find("refused"), std::string::npos) << second.err;
  expect_undisturbed(run);
}

TEST(TwoRunsBesideEachOther, DoNotHearEachOther) {
  LiveRun one;
  LiveRun other;
  EXPECT_NE(one.domain(), other.domain());
  expect_undisturbed(one);
  expect_undisturbed(other);
}

}  // namespace
}  // namespace tacit
