// Reads the maps that come with MissionLab, which may not lie in this tree.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "idl/overlay/reader.h"
#include "idl/overlay/writer.h"

namespace tacit {
namespace {

TEST(MissionLabSamples, AreReadWithoutErrorAndPrintedBackByteForByte) {
  const char* folder = std::getenv("TACIT_MISSIONLAB_SAMPLES");
  if (folder == nullptr) {
    GTEST_SKIP() << "TACIT_MISSIONLAB_SAMPLES names no folder of MissionLab's maps";
  }
  int maps = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ovl") continue;
    ++maps;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const OverlayReading reading = read_overlay(text);
    EXPECT_TRUE(reading.findings.empty())
        << to_text(reading.findings.front(), entry.path().string());
    EXPECT_EQ(to_text(reading.map), text) << entry.path();
  }
  EXPECT_GT(maps, 0) << folder;
}

}  // namespace
}  // namespace tacit
