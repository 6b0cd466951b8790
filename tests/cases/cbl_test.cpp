#include "wizard_service/cases/cbl.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "idl/cdl/check.h"
#include "idl/types/config_error.h"
#include "idl/types/random.h"
#include "tests/cases/some_cases.h"

namespace tacit::cbr {
namespace {

namespace fs = std::filesystem;

/// Named by the environment, else beside the source tree; empty when it is not there.
std::string sample() {
  const char* named = std::getenv("TACIT_MISSIONLAB_SAMPLES");
  const fs::path folder =
      named ? fs::path(named) : fs::path(TACIT_SOURCE_DIR) / "../shared/missionlab-samples";
  return testing::text_of(folder / "mars_demos_sample_cbrplanner.cbl");
}

TEST(Cbl, ReadsMissionLabsOwnLibrary) {
  const std::string text = sample();
  if (text.empty()) GTEST_SKIP() << "no sample of MissionLab's library";
  const std::vector<Case> cases = cases_from_cbl(text, "sample.cbl");
  ASSERT_EQ(cases.size(), 5U);
  EXPECT_EQ(cases[0].features.task, Task::ExplosiveOrdnance);
  EXPECT_EQ(cases[1].features.task, Task::Waypoints);
  EXPECT_EQ(cases[4].features.task, Task::Biohazard);
  EXPECT_EQ(cases[4].features.robots, 2);
  EXPECT_EQ(cases[0].record.good_milli, 1000U);
  for (const Case& one : cases) {
    EXPECT_FALSE(cdl::has_error(cdl::check_text(mission_text(one.plan)))) << one.title;
  }
}

TEST(Cbl, EitherReadsOrRefusesWhateverIsMadeOfALibrary) {
  std::string text = sample();
  if (text.empty()) GTEST_SKIP() << "no sample of MissionLab's library";
  Stream chance(11, "cbl");
  for (int round = 0; round < 300; ++round) {
    std::string wrong = text.substr(0, chance.below(text.size()));
    if (round % 2 == 0) wrong = text;
    for (int i = 0; i < 3 && !wrong.empty(); ++i) {
      wrong[chance.below(wrong.size())] = static_cast<char>(chance.below(256));
    }
    try {
      (void)cases_from_cbl(wrong, "wrong.cbl");
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find("wrong.cbl"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace tacit::cbr
