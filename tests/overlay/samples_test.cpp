// Reads the maps that come with MissionLab, which may not lie in this tree.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "idl/overlay/change_script.h"
#include "idl/overlay/check.h"
#include "idl/overlay/plan.h"
#include "idl/overlay/reader.h"
#include "idl/overlay/writer.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

/// Named by the environment, else beside the source tree; empty when there is none.
fs::path folder() {
  if (const char* named = std::getenv("TACIT_MISSIONLAB_SAMPLES")) return named;
  const fs::path beside = fs::path(TACIT_SOURCE_DIR) / "../shared/missionlab-samples";
  return fs::is_directory(beside) ? beside : fs::path();
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> maps() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder())) {
    if (entry.path().extension() == ".ovl") found.push_back(entry.path());
  }
  return found;
}

class MissionLabSamples : public testing::Test {
 protected:
  void SetUp() override {
    if (folder().empty()) {
      GTEST_SKIP() << "TACIT_MISSIONLAB_SAMPLES names no folder of MissionLab's samples";
    }
  }
};

TEST_F(MissionLabSamples, AreReadWithoutErrorAndPrintedBackByteForByte) {
  EXPECT_FALSE(maps().empty()) << folder();
  for (const fs::path& file : maps()) {
    const std::string text = text_of(file);
    const OverlayReading reading = read_overlay(text);
    EXPECT_TRUE(reading.findings.empty()) << to_text(reading.findings.front(), file.string());
    EXPECT_FALSE(has_errors(check(reading.map))) << file;
    EXPECT_EQ(to_text(reading.map), text) << file;
  }
}

TEST_F(MissionLabSamples, MeanTheSameWhenPrintedAnew) {
  for (const fs::path& file : maps()) {
    const OverlayMap map = read_overlay(text_of(file)).map;
    EXPECT_EQ(read_overlay(to_canonical_text(map)).map, map) << file;
  }
}

TEST_F(MissionLabSamples, HaveAnEnvironmentScriptThatReadsBack) {
  const ChangeReading reading =
      read_changes(text_of(folder() / "mars_demos_sample_environmental_file"));
  EXPECT_TRUE(reading.findings.empty());
  ASSERT_EQ(reading.script.size(), 1U);
  EXPECT_EQ(std::get<RegionAdd>(reading.script[0].changes.at(0)).cover_percent, 3.0);
  EXPECT_EQ(read_changes(to_text(reading.script)).script, reading.script);
}

TEST_F(MissionLabSamples, HaveAnOfficeWithItsHallwayDoorsAndSuspectObjects) {
  const MapPlan plan =
      plan_of(read_overlay(text_of(folder() / "mars_demos_indoor_bio.ovl")).map, Doors::Open);
  EXPECT_EQ(plan.doors.size(), 4U);
  ASSERT_EQ(plan.halls.size(), 1U);
  EXPECT_EQ(plan.halls[0].width_m, 1.7);
  EXPECT_EQ(plan.objects.size(), 4U);
  EXPECT_EQ(plan.ground.start, (MapPoint{11.5, 27.0}));
}

}  // namespace
}  // namespace tacit
