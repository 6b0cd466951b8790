#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kScenario = R"([scenario]
name = "hut"
mission = "operation"
[physics]
tick_s = 0.1
[operation]
extra_count = 1
starts = [[1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [8.0, 8.0, 0.0]]
map = """
MISSION-AREA 9 9
PP Way1 3 3 0.5
PP Entry 5 5 0.5
"""
)";

constexpr const char* kEvents = R"({"tick":0,"event":"operation_begun","team":2,"extras":1}
{"tick":20,"event":"point_reached","robot":2,"point":1}
{"tick":30,"event":"point_reached","robot":3,"point":2}
{"tick":40,"event":"mission_over","verdict":"accomplished","score_ticks":40}
)";

constexpr const char* kFacts = R"({"key":"k","version":"v","scenario":"hut","seed":1,
"transport":"one-process","robots":3,"learner":"mission","strategy":0,"command_line":[],
"started":"2030-01-31T23:59:59Z"})";

void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

/// The run directory of an operation.
class RecordedOperation : public testing::Test {
 protected:
  RecordedOperation() {
    fs::create_directories(run);
    put(run / "run.json", kFacts);
    put(run / "scenario.toml", kScenario);
    put(run / "events.jsonl", kEvents);
  }
  [[nodiscard]] Finished debrief(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"debrief", run};
    words.insert(words.end(), more.begin(), more.end());
    return tacit(words);
  }
  /// What is said when it is refused as bad input.
  [[nodiscard]] std::string refusal() const {
    const Finished finished = debrief();
    return finished.exit_code == 2 && finished.out.empty() ? finished.err : "(not refused)";
  }

  const Scratch scratch;
  const fs::path run = scratch / "run";
};

TEST_F(RecordedOperation, IsToldAsAChecklist) {
  const Finished finished = debrief();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_NE(finished.out.find(R"(Debrief: 2 of 5 sub-tasks done
  [x] Reach Way1                        Robot 2 was there at tick 20 (2.0 s).
  [ ] Reach Entry                       No robot of the team was there.
)"),
            std::string::npos)
      << finished.out;
}

TEST_F(RecordedOperation, IsToldAsJson) {
  const json told = json::parse(debrief({"--json"}).out, nullptr, false);
  ASSERT_TRUE(told.is_object());
  EXPECT_EQ(told["done"], 2);
  EXPECT_EQ(told["wanted"], 5);
  EXPECT_EQ(told["tasks"][0], json({{"name", "Reach Way1"},
                                    {"done", true},
                                    {"evidence", "Robot 2 was there at tick 20 (2.0 s)."}}));
}

TEST_F(RecordedOperation, WantsNoCoverBesideFriends) {
  std::string blue = kScenario;
  blue.insert(blue.find("starts"), "extra_colour = \"blue\"\n");
  put(run / "scenario.toml", blue);
  EXPECT_EQ(json::parse(debrief({"--json"}).out)["wanted"], 3);
}

TEST_F(RecordedOperation, IsToldAsFarAsItsLogGoes) {
  put(run / "events.jsonl", R"({"tick":0,"event":"operation_begun","team":2,"extras":1}
{"tick":20,"event":"point_)");
  EXPECT_EQ(json::parse(debrief({"--json"}).out)["done"], 0);
}

TEST_F(RecordedOperation, NeedsItsFiles) {
  put(run / "events.jsonl", "nonsense\n");
  EXPECT_NE(refusal().find("events.jsonl: line 1: found nonsense"), std::string::npos) << refusal();
  fs::remove(run / "events.jsonl");
  EXPECT_NE(refusal().find("events.jsonl: cannot be read"), std::string::npos) << refusal();
  fs::remove(run / "scenario.toml");
  EXPECT_NE(refusal().find("scenario.toml: cannot be read"), std::string::npos) << refusal();
  fs::remove(run / "run.json");
  EXPECT_NE(refusal().find("holds no run.json"), std::string::npos) << refusal();
}

TEST_F(RecordedOperation, NeedsAMapThatCanBeRead) {
  std::string scenario = kScenario;
  scenario.replace(scenario.find("Way1 3 3"), 8, "Way1 x 3");
  put(run / "scenario.toml", scenario);
  EXPECT_NE(refusal().find("scenario.toml: [operation] map:"), std::string::npos) << refusal();
}

TEST_F(RecordedOperation, NeedsATeam) {
  std::string scenario = kScenario;
  scenario.replace(scenario.find("= 1"), 3, "= 3");
  put(run / "scenario.toml", scenario);
  EXPECT_NE(refusal().find("none is left for the team"), std::string::npos) << refusal();
}

TEST(Debrief, RefusesARunThatIsNoOperation) {
  const Scratch scratch;
  const Finished run = tacit(
      {"run", "guard", "--duration", "1", "--one-process", "--json", "--out", scratch / "run"});
  EXPECT_FALSE(json::parse(run.out).contains("checklist"));
  const Finished finished = tacit({"debrief", scratch / "run"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("is no operation"), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace tacit
