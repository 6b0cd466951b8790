#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "tests/faults/live_run.h"

namespace tacit {
namespace {

using nlohmann::json;

std::filesystem::path policy_of(const LiveRun& run, int robot) {
  return run.directory() / ("learned/robot_" + std::to_string(robot) + ".json");
}

std::uint64_t updates(const std::filesystem::path& policy) {
  const json read = json::parse(text_of(policy), nullptr, false);
  return read.is_object() ? read["schedule"].value("updates", std::uint64_t{0}) : 0;
}

/// None while it is not there.
std::optional<pid_t> agent_of(const LiveRun& run, int robot) {
  try {
    return run.agent(robot);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

TEST(KilledForager, GoesOnFromItsLastLesson) {
  LiveRun run = LiveRun::of_foragers({"--learner", "q", "--set", "mud.per_tick=0.0005"});
  const std::filesystem::path policy = policy_of(run, 2);
  ASSERT_TRUE(becomes_true([&] { return updates(policy) >= 3; }));
  const pid_t before = run.agent(2);
  kill(before, SIGKILL);
  const std::uint64_t kept = updates(policy);
  ASSERT_TRUE(becomes_true([&] { return agent_of(run, 2).value_or(before) != before; }));
  ASSERT_TRUE(becomes_true([&] { return updates(policy) > kept; }));
  EXPECT_GE(kept, 3U);
  run.launcher().send(SIGINT);
  EXPECT_EQ(run.launcher().finish().exit_code, 130);
}

TEST(KilledForageTeam, HasItsLessonsOnDisk) {
  LiveRun run = LiveRun::of_foragers({"--learner", "q", "--set", "mud.per_tick=0.0005"});
  const std::filesystem::path policy = policy_of(run, 1);
  ASSERT_TRUE(becomes_true([&] { return updates(policy) >= 3; }));
  for (const pid_t child : run.children()) {
    kill(child, SIGKILL);
  }
  run.launcher().send(SIGKILL);
  (void)run.launcher().finish();
  EXPECT_GE(updates(policy), 3U);
}

}  // namespace
}  // namespace tacit
