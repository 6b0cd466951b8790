// The cases that ship.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "idl/cdl/check.h"
#include "tests/cases/some_cases.h"
#include "tests/cbr/shelf.h"
#include "wizard_service/cases/case_text.h"
#include "wizard_service/cases/seed.h"
#include "wizard_service/cbr/features.h"

namespace tacit::cbr {
namespace {

using testing::Shelf;

TEST(Seeds, AreMissionsWithoutErrors) {
  for (const auto& file : testing::seed_files()) {
    EXPECT_FALSE(cdl::has_error(cdl::check_text(testing::text_of(file)))) << file;
  }
}

TEST(Seeds, ReadBackWhatTheyPrint) {
  const Shelf shelf;
  for (const Case& one : shelf.all()) {
    const Case again = case_from(to_text(one), one.origin);
    EXPECT_EQ(again.title, one.title);
    EXPECT_EQ(again.features, one.features);
    EXPECT_EQ(again.plan, one.plan) << one.origin;
  }
}

TEST(Seeds, SayWhatTheyAreForAsManyRobotsAsTheyHave) {
  const Shelf shelf;
  for (const Case& one : shelf.all()) {
    EXPECT_FALSE(one.title.empty()) << one.origin;
    EXPECT_EQ(one.features.robots, static_cast<int>(one.plan.robots.size())) << one.origin;
  }
}

TEST(Seeds, AreNotTwoForTheSame) {
  std::map<std::string, std::string> known;
  const Shelf shelf;
  for (const Case& one : shelf.all()) {
    const auto [other, is_new] = known.emplace(to_text(one.features), one.origin);
    EXPECT_TRUE(is_new) << one.origin << " is for the same as " << other->second;
  }
}

TEST(Seeds, AreForEveryTask) {
  std::set<Task> tasks;
  const Shelf shelf;
  for (const Case& one : shelf.all()) tasks.insert(one.features.task);
  EXPECT_EQ(tasks.size(), kTasks);
}

TEST(Seeds, AreWhatANewCaseBaseBeginsWith) {
  const testing::Folder folder;
  CaseBase base(folder.file());
  seed_if_new(base, shipped_seeds());
  EXPECT_EQ(base.heads().size(), Shelf().all().size());
}

}  // namespace
}  // namespace tacit::cbr
