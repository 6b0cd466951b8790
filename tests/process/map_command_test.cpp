#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

TEST(MapCommand, MakesAnOfficeThatItFindsNothingWrongWith) {
  const Scratch scratch;
  const std::string file = scratch / "office.ovl";
  ASSERT_EQ(tacit({"map", "generate", "--seed", "7", "--rooms", "5", "-o", file}).exit_code, 0);
  const Finished checked = tacit({"map", "check", file, "--json"});
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(checked.out, nullptr, false), nlohmann::json::array());
}

TEST(MapCommand, DrawsAMapInLettersAndAsSvg) {
  const Scratch scratch;
  const std::string file = scratch / "office.ovl";
  ASSERT_EQ(tacit({"map", "generate", "--seed", "7", "-o", file}).exit_code, 0);
  const Finished letters = tacit({"map", "show", file, "--text"});
  EXPECT_NE(letters.out.find("####"), std::string::npos) << letters.out;
  EXPECT_NE(letters.out.find('S'), std::string::npos) << letters.out;
  EXPECT_EQ(tacit({"map", "show", file}).out.rfind("<svg", 0), 0U);
}

TEST(MapCommand, EndsWithTwoAndThePlaceOfAnError) {
  const Scratch scratch;
  const std::string file = scratch / "bad.ovl";
  std::ofstream(file) << "OBSTACLE 1 2\n";
  const Finished checked = tacit({"map", "check", file});
  EXPECT_EQ(checked.exit_code, 2);
  EXPECT_NE(checked.out.find("bad.ovl:1:13: error: found the end of OBSTACLE"), std::string::npos)
      << checked.out;
  EXPECT_EQ(tacit({"map", "show", file}).exit_code, 2);
}

TEST(MapCommand, RefusesAnOfficeThatCannotBe) {
  const Finished made = tacit({"map", "generate", "--seed", "7", "--rooms", "9"});
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_NE(made.err.find("rooms = 9, wanted 2 to 8"), std::string::npos) << made.err;
}

}  // namespace
}  // namespace tacit
