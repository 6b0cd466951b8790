#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kGood =
    "instBP $A from movement(bound_to = base:DRIVE(v = FSA(\n"
    "  society[Start]<1,2>|Begin| = [ %Goal_Location = {10, 20}, GoTo],\n"
    "  society[$B] = [Stop], rules[Start] = if [ %Goal_Tolerance = {0.5}, AtGoal] goto $B)));\n"
    "[ vehicle(bound_to = one:MRV2([ $A])) ]\n";
constexpr const char* kUndefined = "\n[ vehicle(bound_to = one:MRV2([ $A])) ]\n";

/// A folder with one mission in it.
class MissionCommand : public testing::Test {
 protected:
  Finished mission(const std::vector<std::string>& words, const std::string& text,
                   const Limits& limits = {}) {
    std::ofstream(file_, std::ios::binary) << text;
    std::vector<std::string> all{"mission"};
    all.insert(all.end(), words.begin(), words.end());
    all.push_back(file_);
    return tacit(all, limits);
  }

  /// Names of what is in the folder.
  [[nodiscard]] std::vector<std::string> left() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(file_.parent_path())) {
      names.push_back(entry.path().filename());
    }
    return names;
  }

  Scratch scratch_;
  fs::path file_ = scratch_ / "walk.cdl";
};

TEST_F(MissionCommand, ChecksAGoodMission) {
  const Finished finished = mission({"check"}, kGood);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, file_.string() + ": nothing to say\n");
}

TEST_F(MissionCommand, ChecksEndWithTwoAtAnError) {
  const Finished finished = mission({"check"}, kUndefined);
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.out.find(file_.string() + ":2:33: error: nothing is called $A"),
            std::string::npos)
      << finished.out;
}

TEST_F(MissionCommand, ChecksEndWellWithWarningsAlone) {
  const Finished finished = mission({"check"}, "bindArch AuRA;\n");
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_NE(finished.out.find("warning: the file has no robots"), std::string::npos);
}

TEST_F(MissionCommand, ChecksPrintExactlyOneObjectWithJson) {
  const Finished finished = mission({"check", "--json"}, kUndefined);
  EXPECT_EQ(finished.exit_code, 2);
  const json found = json::parse(finished.out, nullptr, false);
  ASSERT_TRUE(found.is_object()) << finished.out;
  EXPECT_EQ(found["file"], file_.string());
  EXPECT_EQ(found["ok"], false);
  const json& first = found["findings"].at(0);
  EXPECT_EQ(first["severity"], "error");
  EXPECT_EQ(first["rule"], "undefined-name");
  EXPECT_EQ(first["line"], 2);
  EXPECT_EQ(first["column"], 33);
}

TEST_F(MissionCommand, ChecksSayItIsWellWithJson) {
  const Finished finished = mission({"check", "--json"}, kGood);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(json::parse(finished.out),
            (json{{"file", file_}, {"ok", true}, {"findings", json::array()}}));
}

TEST_F(MissionCommand, PrintsJsonOfAnyBytes) {
  const Finished finished = mission({"check", "--json"}, "instBP \xE9 \x01 \xFF from {\xE9");
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_TRUE(json::parse(finished.out, nullptr, false).is_object()) << finished.out;
}

TEST_F(MissionCommand, RefusesWhatCannotBeRead) {
  for (const char* work : {"check", "format", "show"}) {
    for (const fs::path& file : {scratch_ / "absent.cdl", file_.parent_path()}) {
      const Finished finished = tacit({"mission", work, file});
      EXPECT_EQ(finished.exit_code, 2) << work << ' ' << file;
      EXPECT_NE(finished.err.find(file.string()), std::string::npos) << finished.err;
    }
  }
}

TEST_F(MissionCommand, FormatsWithoutTouchingTheFile) {
  const Finished finished = mission({"format"}, "[a, /*b*/ c]");
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "[\n  a,\n  /*b*/\n  c]\n");
  EXPECT_EQ(text_of(file_), "[a, /*b*/ c]");
}

TEST_F(MissionCommand, FormatsTheFileItself) {
  const Finished finished = mission({"format", "--write"}, "[a, b]");
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(text_of(file_), "[\n  a,\n  b]\n");
  EXPECT_EQ(left(), std::vector<std::string>{"walk.cdl"});
}

TEST_F(MissionCommand, LeavesAFileInTheHouseLayoutAlone) {
  (void)mission({"format", "--write"}, "[\n  a]\n");
  const auto written = fs::last_write_time(file_);
  EXPECT_EQ(tacit({"mission", "format", "--write", file_}).err, "");
  EXPECT_EQ(fs::last_write_time(file_), written);
}

TEST_F(MissionCommand, LeavesAFileWithErrorsAlone) {
  const Finished finished = mission({"format", "--write"}, "[a, b");
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find(":1:6: error: "), std::string::npos) << finished.err;
  EXPECT_EQ(text_of(file_), "[a, b");
}

TEST_F(MissionCommand, LeavesTheFileAloneWhenTheDiskIsFull) {
  // 4 kB, which are 10 kB in the house layout.
  std::string list = "[a";
  for (int i = 0; i < 2000; ++i) {
    list += ",b";
  }
  const Finished finished = mission({"format", "--write"}, list + "]", Limits{5000});
  EXPECT_NE(finished.exit_code, 0);
  EXPECT_NE(finished.err.find("cannot be written"), std::string::npos) << finished.err;
  EXPECT_EQ(text_of(file_), list + "]");
  EXPECT_EQ(left(), std::vector<std::string>{"walk.cdl"});
}

TEST_F(MissionCommand, FormatsTheFileBehindALinkAndKeepsItsRights) {
  const fs::path link = scratch_ / "link.cdl";
  std::ofstream(file_) << "[a, b]";
  fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(file_, link);
  EXPECT_EQ(tacit({"mission", "format", "--write", link}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(text_of(file_), "[\n  a,\n  b]\n");
  EXPECT_EQ(fs::status(file_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(MissionCommand, ShowsTheAutomataForMermaid) {
  const Finished finished = mission({"show"}, kGood);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(finished.out.starts_with("stateDiagram-v2\n")) << finished.out;
  EXPECT_NE(finished.out.find("[*] --> r0_d0_s0\n"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("r0_d0_s0 --> r0_d0_s1 : AtGoal(0.5)\n"), std::string::npos);
}

TEST_F(MissionCommand, ShowsTheAutomataForGraphviz) {
  const Finished finished = mission({"show", "--as", "dot"}, kGood);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(finished.out.starts_with("digraph team {\n")) << finished.out;
  EXPECT_NE(finished.out.find("r0_d0_s0 -> r0_d0_s1 [label=\"AtGoal(0.5)\"];\n"), std::string::npos)
      << finished.out;
}

TEST_F(MissionCommand, ShowsTheAutomataAsStateChartXml) {
  const Finished finished = mission({"show", "--as", "scxml"}, kGood);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(finished.out.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<scxml "));
  EXPECT_NE(finished.out.find("<transition event=\"AtGoal\" target=\"r0_d0_s1\""),
            std::string::npos)
      << finished.out;
  EXPECT_TRUE(finished.out.ends_with("</scxml>\n"));
}

TEST_F(MissionCommand, ShowsNothingOfAMissionWithoutRobots) {
  const Finished finished = mission({"show"}, "bindArch AuRA;");
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_EQ(finished.out, "");
}

TEST_F(MissionCommand, RefusesALanguageThatItDoesNotDrawIn) {
  EXPECT_EQ(mission({"show", "--as", "svg"}, kGood).exit_code, 2);
}

}  // namespace
}  // namespace tacit
