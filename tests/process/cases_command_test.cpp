#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kMissions = TACIT_SOURCE_DIR "/deploy/missions/";

/// A case base of its own, which begins with nothing.
class CasesCommand : public testing::Test {
 protected:
  CasesCommand() {
    fs::create_directories(scratch / "seeds");
    fs::create_directories(scratch / "home");
  }

  [[nodiscard]] Finished cases(std::vector<std::string> words) const {
    words.insert(words.begin(), "cases");
    words.insert(words.end(), {"--cases", scratch / "cases.db", "--seeds", scratch / "seeds"});
    return tacit(words);
  }
  /// What is said when it is refused as bad input.
  [[nodiscard]] std::string refusal(const std::vector<std::string>& words) const {
    const Finished finished = cases(words);
    return finished.exit_code == 2 && finished.out.empty() ? finished.err : "(not refused)";
  }
  [[nodiscard]] json listed(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"list", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return json::parse(cases(words).out, nullptr, false);
  }
  /// A file with the case of a mission that ships.
  [[nodiscard]] std::string case_file(const std::string& mission, const std::string& head) const {
    const fs::path file = scratch / (mission + ".cdl");
    std::ofstream(file) << "/* " << head << " */\n" << text_of(kMissions + mission + ".cdl");
    return file;
  }
  void import_two() const {
    ASSERT_EQ(
        cases({"import", case_file("eod", "Case: Mines to the pit\n * Task: EOD"),
               case_file("biohazard_pair",
                         "Case: Two cover each other\n * Task: Biohazard\n * HandlesEnemy: True")})
            .exit_code,
        0);
  }

  const Scratch scratch;
};

TEST_F(CasesCommand, BeginsWithTheSeeds) {
  fs::rename(case_file("eod", "Case: Mines\n * Task: EOD"), scratch / "seeds" / "eod.cdl");
  const json list = listed();
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0]["title"], "Mines");
  EXPECT_EQ(list[0]["origin"], "seed");
}

TEST_F(CasesCommand, TellsOfANewFileOnce) {
  EXPECT_NE(cases({"list"}).err.find("made the case base"), std::string::npos);
  EXPECT_EQ(cases({"list"}).err, "");
}

TEST_F(CasesCommand, SaysWhatImportStoredAndWhatWasThere) {
  const std::string eod = case_file("eod", "Case: Mines\n * Task: EOD");
  EXPECT_EQ(cases({"import", eod}).out, "Stored 1 new case; 0 were there.\n");
  EXPECT_EQ(cases({"import", eod, eod}).out, "Stored 0 new cases; 2 were there.\n");
}

TEST_F(CasesCommand, ListsFeaturesAndFiltersByThem) {
  import_two();
  const json list = listed();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1]["title"], "Two cover each other");
  EXPECT_EQ(list[1]["features"], json({{"task", "BiohazardTask"},
                                       {"robots", 2},
                                       {"localization", "UseLandmarks"},
                                       {"environment", "Indoor"},
                                       {"handles_enemy", true}}));
  EXPECT_EQ(listed({"--task", "eod"}).size(), 1U);
  EXPECT_EQ(listed({"--robots", "2"}).at(0)["id"], 2);
  EXPECT_EQ(listed({"--task", "eod", "--robots", "2"}).size(), 0U);
  const Finished table = cases({"list"});
  EXPECT_NE(table.out.find("2 cases"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("Mines to the pit"), std::string::npos) << table.out;
}

TEST_F(CasesCommand, ShowsACaseThatImportKnowsAgain) {
  import_two();
  const Finished shown = cases({"show", "2"});
  EXPECT_NE(shown.out.find(" * Task: BiohazardTask\n"), std::string::npos) << shown.out;
  std::ofstream(scratch / "again.cdl") << shown.out;
  EXPECT_EQ(cases({"import", scratch / "again.cdl"}).out, "Stored 0 new cases; 1 was there.\n");
}

TEST_F(CasesCommand, ExportsWhatImportKnowsAgain) {
  import_two();
  ASSERT_EQ(cases({"export", "--out", scratch / "out"}).exit_code, 0);
  EXPECT_EQ(cases({"import", scratch / "out" / "1_mines_to_the_pit.cdl",
                   scratch / "out" / "2_two_cover_each_other.cdl"})
                .out,
            "Stored 0 new cases; 2 were there.\n");
}

TEST_F(CasesCommand, OverwritesNothingUnlessForced) {
  import_two();
  fs::create_directories(scratch / "out");
  const fs::path file = scratch / "out" / "1_mines_to_the_pit.cdl";
  std::ofstream(file) << "mine";
  EXPECT_NE(refusal({"export", "--out", scratch / "out"}).find("is there already"),
            std::string::npos);
  EXPECT_EQ(text_of(file), "mine");
  EXPECT_FALSE(fs::exists(scratch / "out" / "2_two_cover_each_other.cdl"));
  EXPECT_EQ(cases({"export", "1", "--out", scratch / "out", "--force"}).exit_code, 0);
  EXPECT_NE(text_of(file), "mine");
}

TEST_F(CasesCommand, RatesByWordAndByNumber) {
  import_two();
  EXPECT_EQ(cases({"rate", "1", "Good"}).out, "Case 1: 1 of 1 good\n");
  EXPECT_EQ(cases({"rate", "1", "0.25", "--because", "It forgot a mine."}).out,
            "Case 1: 1.25 of 2 good\n");
  EXPECT_EQ(listed().at(0)["record"]["failures"],
            json::array({{{"what", "It forgot a mine."}, {"map", ""}}}));
}

TEST_F(CasesCommand, RemovesAllThatAreNamedOrNone) {
  import_two();
  EXPECT_NE(refusal({"remove", "1", "7"}).find("case 7 is not there"), std::string::npos);
  EXPECT_EQ(listed().size(), 2U);
  EXPECT_EQ(cases({"remove", "1", "2"}).exit_code, 0);
  EXPECT_EQ(listed().size(), 0U);
}

TEST_F(CasesCommand, FindsNoFlawsInWhatItStored) {
  import_two();
  const Finished flaws = cases({"flaws"});
  EXPECT_EQ(flaws.exit_code, 0);
  EXPECT_EQ(flaws.out, "2 cases, 0 flaws\n");
  EXPECT_EQ(json::parse(cases({"flaws", "--json"}).out, nullptr, false), json::array());
}

TEST_F(CasesCommand, RefusesABadFileAndStoresNoneOfTheOthers) {
  const std::string good = case_file("eod", "Case: Mines\n * Task: EOD");
  const std::string bad = case_file("biohazard", "Case: Searching\n * Task: Dancing");
  std::ofstream(scratch / "notes.txt") << "x";
  const std::string said =
      refusal({"import", good, bad, scratch / "notes.txt", scratch / "absent.cbl"});
  EXPECT_NE(said.find("biohazard.cdl:2: "), std::string::npos) << said;
  EXPECT_NE(said.find("Dancing"), std::string::npos) << said;
  EXPECT_NE(said.find("notes.txt: wanted a case (.cdl) or a case library (.cbl)"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("absent.cbl: No such file"), std::string::npos) << said;
  EXPECT_EQ(listed().size(), 0U);
}

TEST_F(CasesCommand, ReadsMissionLabsOwnLibrary) {
  const fs::path library =
      fs::path(TACIT_SOURCE_DIR) / "../shared/missionlab-samples/mars_demos_sample_cbrplanner.cbl";
  if (!fs::exists(library)) GTEST_SKIP() << "no sample of MissionLab's library";
  EXPECT_EQ(cases({"import", library}).out, "Stored 5 new cases; 0 were there.\n");
}

TEST_F(CasesCommand, NamesTheLineOfALibraryThatIsDamaged) {
  std::ofstream(scratch / "cut.cbl") << "DATA START\nPLAN START\nDATA END\n";
  const std::string said = refusal({"import", scratch / "cut.cbl"});
  EXPECT_NE(said.find("cut.cbl:3: found the end of DATA, wanted that of PLAN"), std::string::npos)
      << said;
}

TEST_F(CasesCommand, RefusesWhatIsNotThereAndWhatMakesNoSense) {
  import_two();
  EXPECT_NE(refusal({"show", "9"}).find("case 9 is not there"), std::string::npos);
  EXPECT_NE(refusal({"rate", "9", "good"}).find("case 9 is not there"), std::string::npos);
  EXPECT_NE(refusal({"rate", "1", "1.5"}).find("found the verdict \"1.5\""), std::string::npos);
  EXPECT_NE(refusal({"rate", "1", "nan"}).find("found the verdict \"nan\""), std::string::npos);
  EXPECT_NE(refusal({"rate", "1", "good", "--because", "x"}).find("--because"), std::string::npos);
  EXPECT_NE(refusal({"export", "9", "--out", scratch / "out"}).find("case 9 is not there"),
            std::string::npos);
  EXPECT_NE(refusal({"list", "--task", "dancing"}).find("dancing"), std::string::npos);
  EXPECT_EQ(cases({"list", "--robots", "11"}).exit_code, 2);
  EXPECT_EQ(cases({"show", "one"}).exit_code, 2);
  EXPECT_EQ(cases({}).exit_code, 2);
}

TEST_F(CasesCommand, RefusesAFileThatIsNoCaseBase) {
  std::ofstream(scratch / "cases.db") << std::string(5000, 'x');
  EXPECT_NE(refusal({"list"}).find("wanted a case base"), std::string::npos);
}

TEST_F(CasesCommand, NamesAFolderThatIsNotThere) {
  const Finished lost = tacit({"cases", "list", "--cases", scratch / "no" / "cases.db"});
  EXPECT_EQ(lost.exit_code, 2);
  EXPECT_NE(lost.err.find("--cases: there is no directory"), std::string::npos) << lost.err;
  const Finished seedless =
      tacit({"cases", "list", "--cases", scratch / "cases.db", "--seeds", scratch / "no"});
  EXPECT_EQ(seedless.exit_code, 2);
  EXPECT_NE(seedless.err.find("--seeds: there is no directory"), std::string::npos) << seedless.err;
  EXPECT_FALSE(fs::exists(scratch / "cases.db"));
}

}  // namespace
}  // namespace tacit
