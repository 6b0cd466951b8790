#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

using nlohmann::json;

void draw_map(const std::filesystem::path& file) {
  std::ofstream(file) << "MISSION-AREA 60 40\nCONTROL MEASURES:\nPP StartPlace 20 20 0.2\n"
                         "WALL w 30 0 30 40\nDOOR d 30 18 30 22\nOBSTACLE 20 30 2\n"
                         "OBJECT 40 20 0.3 Movable orange\n";
}

json result(const Scratch& scratch, const std::string& mission, bool one_process) {
  std::vector<std::string> words{
      "run",        mission,
      "--map",      scratch / "hut.ovl",
      "--seed",     "5",
      "--robots",   "3",
      "--json",     "--quiet",
      "--duration", "60",
      "--out",      scratch / (mission + (one_process ? "-one" : "-dds"))};
  if (one_process) words.emplace_back("--one-process");
  const Finished finished = tacit(words);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return json::parse(finished.out, nullptr, false);
}

class SameRunOnAMap : public testing::TestWithParam<const char*> {};

TEST_P(SameRunOnAMap, HasTheSameEventLogOverDdsInOneProcessAndAgainWithoutTheMap) {
  const Scratch scratch;
  draw_map(scratch / "hut.ovl");
  const json dds = result(scratch, GetParam(), false);
  const json one = result(scratch, GetParam(), true);
  ASSERT_TRUE(dds.is_object() && one.is_object());
  EXPECT_EQ(dds["event_log_sha256"], one["event_log_sha256"]);
  std::filesystem::remove(scratch / "hut.ovl");
  const Finished again = tacit({"verify", scratch / (std::string(GetParam()) + "-dds")});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

INSTANTIATE_TEST_SUITE_P(Missions, SameRunOnAMap, testing::Values("guard", "forage"));

}  // namespace
}  // namespace tacit
