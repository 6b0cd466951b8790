#include "wizard_service/cbr/plan_cdl.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "idl/cdl/check.h"
#include "idl/cdl/parse.h"
#include "idl/cdl/resolve.h"
#include "idl/types/config_error.h"

namespace tacit::cbr {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> missions_in(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".cdl") found.push_back(entry.path());
  }
  return found;
}

std::vector<fs::path> shipped() {
  return missions_in(fs::path(TACIT_SOURCE_DIR) / "deploy/missions");
}

TEST(PlanCdl, PrintsAPlanThatReadsBackEqual) {
  for (const fs::path& file : shipped()) {
    const Plan plan = plan_of(text_of(file), file.string());
    EXPECT_EQ(plan_of(mission_text(plan), "printed"), plan) << file;
  }
}

TEST(PlanCdl, PrintsMissionsWithoutErrors) {
  for (const fs::path& file : shipped()) {
    const std::string text = mission_text(plan_of(text_of(file), file.string()), "Said of it.");
    const cdl::Findings findings = cdl::check_text(text);
    EXPECT_FALSE(cdl::has_error(findings)) << file << '\n' << text;
  }
}

TEST(PlanCdl, KeepsWhatEveryRobotDoes) {
  for (const fs::path& file : shipped()) {
    const std::string text = text_of(file);
    const auto before = cdl::resolve(cdl::parse(text).mission).robots;
    const auto after =
        cdl::resolve(cdl::parse(mission_text(plan_of(text, "before"))).mission).robots;
    ASSERT_EQ(before.size(), after.size()) << file;
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].name, after[i].name);
      const auto& a = std::get<cdl::Automaton>(before[i].actuators[0].inputs[0].behaviour.form);
      const auto& b = std::get<cdl::Automaton>(after[i].actuators[0].inputs[0].behaviour.form);
      ASSERT_EQ(a.states.size(), b.states.size());
      for (std::size_t s = 0; s < a.states.size(); ++s) {
        EXPECT_EQ(a.states[s].behaviour.name, b.states[s].behaviour.name);
        EXPECT_EQ(a.states[s].rules.size(), b.states[s].rules.size());
      }
    }
  }
}

TEST(PlanCdl, ReadsTheRobotsSpeeds) {
  const Plan plan =
      plan_of(text_of(fs::path(TACIT_SOURCE_DIR) / "deploy/missions/biohazard_pair.cdl"), "pair");
  ASSERT_EQ(plan.robots.size(), 2U);
  EXPECT_EQ(plan.robots[0].name, "Surveyor");
  EXPECT_EQ(plan.robots[1].name, "Cover");
  EXPECT_DOUBLE_EQ(plan.robots[0].max_mps, 0.8);
  EXPECT_DOUBLE_EQ(plan.robots[0].base_mps, 0.4);
  EXPECT_TRUE(plan.robots[0].cautious);
  ASSERT_EQ(plan.shared.size(), 1U);
}

TEST(PlanCdl, NamesWhatIsNoMission) {
  try {
    (void)plan_of("instBP", "draft.cdl");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("draft.cdl:1"), std::string::npos) << error.what();
  }
}

TEST(PlanCdl, RefusesATeamWithoutRobots) {
  EXPECT_THROW((void)plan_of("bindArch AuRA.urban;\n", "empty"), ConfigError);
}

TEST(PlanCdl, FindsAndSetsParameters) {
  cdl::Expression go = behaviour("GoTo", {{"Goal_Location", "1, 2"}});
  EXPECT_EQ(behaviour_name(go), "GoTo");
  EXPECT_EQ(*parameter(go, "Goal_Location"), "1, 2");
  EXPECT_EQ(parameter(go, "wander_gain"), nullptr);
  set_parameter(go, "Goal_Location", "3, 4");
  set_parameter(go, "wander_gain", "0.1");
  EXPECT_EQ(*parameter(go, "Goal_Location"), "3, 4");
  EXPECT_EQ(*parameter(go, "wander_gain"), "0.1");
  EXPECT_EQ(behaviour_name(go), "GoTo");
}

TEST(PlanCdl, ReadsMissionLabsOwnMissions) {
  const char* named = std::getenv("TACIT_MISSIONLAB_SAMPLES");
  const fs::path folder =
      named ? fs::path(named) : fs::path(TACIT_SOURCE_DIR) / "../shared/missionlab-samples";
  if (!fs::is_directory(folder)) GTEST_SKIP() << "no samples of MissionLab at " << folder;
  for (const fs::path& file : missions_in(folder)) {
    const std::string name = file.filename().string();
    if (name == "mlab-2.0_demos_wander.cdl") {  // Its robot wanders, without any automaton.
      EXPECT_THROW((void)plan_of(text_of(file), name), ConfigError);
      continue;
    }
    const Plan plan = plan_of(text_of(file), name);
    EXPECT_EQ(plan_of(mission_text(plan), "printed"), plan) << file;
  }
}

}  // namespace
}  // namespace tacit::cbr
