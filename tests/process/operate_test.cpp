#include <gtest/gtest.h>

#include "tests/process/programs.h"

namespace tacit {
namespace {

TEST(Operate, HelpsARobotThatWaitsAndStopsTheRun) {
  const Scratch scratch;
  const std::string run = scratch / "run";
  // The robots wait for nothing; what is tested is that the words arrive and are logged.
  Running running(tacit_words({"run", "waypoints.cdl", "--map", "waypoints.ovl", "--speed", "20",
                               "--set", "operator.proceed=ask", "--quiet", "--out", run}));
  const auto log = [&run] { return text_of(run + "/events.jsonl"); };
  ASSERT_TRUE(becomes_true([&] { return log().find("site_entered") != std::string::npos; }));
  const auto operate = [&run](std::vector<std::string> words) {
    words.insert(words.begin(), {"operate", run});
    return tacit(words).exit_code;
  };
  EXPECT_EQ(operate({"proceed", "--robot", "1"}), 0);
  EXPECT_EQ(operate({"skip-goal"}), 0);
  EXPECT_EQ(operate({"steer", "0", "1", "--robot", "1"}), 0);
  EXPECT_EQ(operate({"let-go", "--robot", "1"}), 0);
  EXPECT_TRUE(becomes_true([&] {
    const std::string text = log();
    return text.find("\"act\":\"proceed\"") != std::string::npos &&
           text.find("\"act\":\"skip_goal\"") != std::string::npos &&
           text.find("\"act\":\"steer\"") != std::string::npos &&
           text.find("\"act\":\"let_go\"") != std::string::npos;
  }));
  EXPECT_EQ(operate({"pause"}), 0);
  EXPECT_EQ(operate({"step", "3"}), 0);
  EXPECT_EQ(operate({"stop"}), 0);
  EXPECT_EQ(running.finish().exit_code, 130);
  EXPECT_NE(tacit({"operate", run, "pause"}).err.find("no run over DDS is on there"),
            std::string::npos);
}

TEST(Operate, RefusesWhatIsNoWord) {
  EXPECT_EQ(tacit({"operate", "/nowhere", "dance"}).exit_code, 2);
  EXPECT_NE(tacit({"operate", "/nowhere", "steer", "2", "0"}).err.find("-1 to 1 each"),
            std::string::npos);
  EXPECT_NE(tacit({"operate", "/nowhere", "speed"}).err.find("times real time"), std::string::npos);
  EXPECT_NE(tacit({"operate", "/nowhere", "pause", "1"}).err.find("wanted at most 0"),
            std::string::npos);
}

}  // namespace
}  // namespace tacit
