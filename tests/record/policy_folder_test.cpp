#include "console/record/policy_folder.h"

#include <gtest/gtest.h>

#include "console/record/record_error.h"
#include "idl/types/config_error.h"
#include "tests/record/scratch.h"

namespace tacit {
namespace {

using PolicyFolderTest = ScratchTest;

TEST_F(PolicyFolderTest, GivesBackWhatItWasGiven) {
  const PolicyFolder policies(folder / "new");
  policies.save({"one", "two"});
  const std::vector<PolicyText> found = policies.load(2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].text, "one");
  EXPECT_EQ(found[1].text, "two");
  EXPECT_EQ(found[1].name, (folder / "new/robot_2.json").string());
}

TEST_F(PolicyFolderTest, KeepsTheOrderOfRobotsBeyondTen) {
  const PolicyFolder policies(folder);
  std::vector<std::string> texts;
  for (int robot = 1; robot <= 12; ++robot) {
    texts.push_back(std::to_string(robot));
  }
  policies.save(texts);
  const std::vector<PolicyText> found = policies.load(12);
  ASSERT_EQ(found.size(), 12U);
  EXPECT_EQ(found[1].text, "2");
  EXPECT_EQ(found[11].text, "12");
}

TEST_F(PolicyFolderTest, IsEmptyWhenItIsNotThereOrHoldsOtherFiles) {
  EXPECT_TRUE(PolicyFolder(folder / "nowhere").load(2).empty());
  put(folder / "robot_x.json", "");
  put(folder / "notes.txt", "");
  EXPECT_TRUE(PolicyFolder(folder).load(2).empty());
}

TEST_F(PolicyFolderTest, RefusesThePoliciesOfAnotherTeam) {
  const PolicyFolder policies(folder);
  policies.save({"one", "two"});
  const std::string said = complaint<ConfigError>([&] { static_cast<void>(policies.load(6)); });
  EXPECT_NE(said.find("holds the policies of robots 1, 2, wanted those of robots 1 to 6"),
            std::string::npos)
      << said;
}

TEST_F(PolicyFolderTest, RefusesATeamWithAGap) {
  put(folder / "robot_1.json", "");
  put(folder / "robot_3.json", "");
  EXPECT_THROW(static_cast<void>(PolicyFolder(folder).load(2)), ConfigError);
}

TEST_F(PolicyFolderTest, RefusesAFileInPlaceOfAFolder) {
  put(folder / "file", "");
  EXPECT_THROW(static_cast<void>(PolicyFolder(folder / "file").load(2)), ConfigError);
  EXPECT_THROW(PolicyFolder(folder / "file").save({"one"}), RecordError);
}

TEST_F(PolicyFolderTest, LeavesNoDraftsBehind) {
  const PolicyFolder policies(folder);
  policies.save({"one"});
  policies.save({"another"});
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

}  // namespace
}  // namespace tacit
