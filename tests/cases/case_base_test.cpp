#include "wizard_service/cases/case_base.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "idl/types/config_error.h"
#include "tests/cases/some_cases.h"

namespace tacit::cbr {
namespace {

using testing::Folder;
using testing::shipped_case;

TEST(CaseBase, GivesBackWhatWasStored) {
  const Folder folder;
  const Case wanted = shipped_case("biohazard_pair", Task::Biohazard);
  CaseId id = 0;
  {
    CaseBase base(folder.file());
    id = base.store(wanted).id;
  }
  CaseBase base(folder.file());
  const Case& found = base.find(id);
  EXPECT_EQ(found.plan, wanted.plan);
  EXPECT_EQ(found.features, wanted.features);
  EXPECT_EQ(found.title, wanted.title);
  ASSERT_EQ(base.heads().size(), 1U);
  EXPECT_EQ(base.heads()[0].features, wanted.features);
}

TEST(CaseBase, KeepsACaseOnce) {
  const Folder folder;
  CaseBase base(folder.file());
  const Stored first = base.store(shipped_case("eod", Task::ExplosiveOrdnance));
  const Stored second = base.store(shipped_case("eod", Task::ExplosiveOrdnance));
  EXPECT_TRUE(first.fresh);
  EXPECT_FALSE(second.fresh);
  EXPECT_EQ(first.id, second.id);
  EXPECT_EQ(base.size(), 1U);
}

TEST(CaseBase, TakesWhatDiffersInNamesAloneForTheSameCase) {
  const Folder folder;
  CaseBase base(folder.file());
  Case renamed = shipped_case("eod", Task::ExplosiveOrdnance);
  base.store(renamed);
  renamed.title = "Another name";
  renamed.plan.robots[0].states[0].label = "Begin";
  EXPECT_FALSE(base.store(renamed).fresh);
}

TEST(CaseBase, RanksByWhatUseHasTaught) {
  const Folder folder;
  CaseBase base(folder.file());
  const CaseId id = base.store(shipped_case("eod", Task::ExplosiveOrdnance)).id;
  EXPECT_EQ(base.heads()[0].standing, 0);
  base.record_outcome(id, 1.0, {});
  EXPECT_GT(base.heads()[0].standing, 0);
  base.record_outcome(id, 0.0, {{"Store mine 1", "minefield"}});
  base.record_outcome(id, 0.0, {});
  EXPECT_LT(base.heads()[0].standing, 0);
  ASSERT_EQ(base.find(id).record.failures.size(), 1U);
  EXPECT_EQ(base.find(id).record.failures[0].map, "minefield");
}

TEST(CaseBase, SeesWhatOthersStore) {
  const Folder folder;
  CaseBase one(folder.file());
  CaseBase other(folder.file());
  (void)one.changed_since_last_look();
  EXPECT_FALSE(one.changed_since_last_look());
  other.store(shipped_case("eod", Task::ExplosiveOrdnance));
  EXPECT_TRUE(one.changed_since_last_look());
  EXPECT_EQ(one.size(), 1U);
}

TEST(CaseBase, LeavesAFileThatIsNoneAsItIs) {
  const Folder folder;
  const std::string text(5000, 'x');
  std::ofstream(folder.file()) << text;
  EXPECT_THROW(CaseBase base(folder.file()), ConfigError);
  EXPECT_EQ(testing::text_of(folder.file()), text);
}

TEST(CaseBase, NamesACaseThatIsNotThere) {
  const Folder folder;
  CaseBase base(folder.file());
  EXPECT_THROW((void)base.find(7), ConfigError);
  EXPECT_THROW(base.remove(7), ConfigError);
}

/// Stores one case after another and tells each through `pipe`, until it is killed.
[[noreturn]] void store_for_ever(const std::filesystem::path& file, int pipe) {
  CaseBase base(file);
  Case one = shipped_case("waypoints", Task::Waypoints);
  for (int i = 1;; ++i) {
    set_parameter(one.plan.robots[0].states[1].behaviour, "wander_gain", std::to_string(i));
    const CaseId id = base.store(one).id;
    if (::write(pipe, &id, sizeof id) != sizeof id) ::_exit(1);
  }
}

TEST(CaseBase, KeepsEveryStoredCaseWhenItsProcessIsKilled) {
  const Folder folder;
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) store_for_ever(folder.file(), ends[1]);
  ::close(ends[1]);
  std::set<CaseId> told;
  CaseId id = 0;
  while (told.size() < 20 && ::read(ends[0], &id, sizeof id) == sizeof id) told.insert(id);
  ::kill(child, SIGKILL);
  while (::read(ends[0], &id, sizeof id) == sizeof id) told.insert(id);
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  ASSERT_GE(told.size(), 20U);
  CaseBase base(folder.file());
  std::set<CaseId> kept;
  for (const CaseHead& head : base.heads()) kept.insert(head.id);
  for (const CaseId one : told) EXPECT_TRUE(kept.contains(one)) << one;
}

}  // namespace
}  // namespace tacit::cbr
