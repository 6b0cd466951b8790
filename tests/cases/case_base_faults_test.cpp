// A case base that others write to, that is damaged, or that is of another version.

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <vector>

#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "tests/cases/some_cases.h"
#include "wizard_service/cases/case_base.h"
#include "wizard_service/cbr/wizard.h"

namespace tacit::cbr {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using testing::shipped_case;

void run_sql(const fs::path& file, const std::string& sql) {
  SQLite::Database db(file.string(), SQLite::OPEN_READWRITE);
  db.exec(sql);
}

Case numbered_case(int number) {
  Case one = shipped_case("waypoints", Task::Waypoints);
  set_parameter(one.plan.robots[0].states[1].behaviour, "wander_gain", std::to_string(number));
  return one;
}

/// A process that opens `file` and stores cases of these numbers, and leaves without a farewell.
pid_t storing(const fs::path& file, int first, int count) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  int failed = 0;
  try {
    CaseBase base(file);
    for (int i = first; i < first + count; ++i)
      failed += base.store(numbered_case(i)).fresh ? 0 : 1;
  } catch (const std::exception&) {
    ++failed;
  }
  ::_exit(failed);
}

TEST(SharedCaseBase, KeepsWhatTwoProcessesStoreAtOnce) {
  constexpr int kEach = 25;
  const Folder folder;
  const std::vector<pid_t> children{storing(folder.file(), 0, kEach),
                                    storing(folder.file(), kEach, kEach)};
  for (const pid_t child : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  CaseBase base(folder.file());
  EXPECT_EQ(base.size(), 2U * kEach);
  EXPECT_TRUE(base.flaws().empty());
}

TEST(SharedCaseBase, KeepsACaseOnceThatTwoProcessesStoreAtOnce) {
  const Folder folder;
  const std::vector<pid_t> children{storing(folder.file(), 0, 10), storing(folder.file(), 0, 10)};
  int refused = 0;
  for (const pid_t child : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    refused += WEXITSTATUS(status);
  }
  EXPECT_EQ(refused, 10);
  EXPECT_EQ(CaseBase(folder.file()).size(), 10U);
}

TEST(CaseBaseVersion, OfALaterTacitIsRefusedAndLeftAsItIs) {
  const Folder folder;
  { CaseBase(folder.file()).store(numbered_case(1)); }
  run_sql(folder.file(), "PRAGMA user_version = 1000; PRAGMA journal_mode = DELETE");
  const std::string before = testing::text_of(folder.file());
  try {
    CaseBase base(folder.file());
    FAIL() << "not refused";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("has schema version 1000, wanted at most"),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(testing::text_of(folder.file()), before);
}

/// As version 1 was: cases remembered no failures, and no report was known again.
void make_older(const fs::path& file) {
  run_sql(file, "DROP TABLE failures; DROP TABLE reports; PRAGMA user_version = 1");
}

TEST(CaseBaseVersion, OfAnEarlierTacitIsBroughtUpToDateWithItsCases) {
  const Folder folder;
  CaseId id = 0;
  {
    CaseBase base(folder.file());
    id = base.store(numbered_case(1)).id;
    base.record_outcome(id, 0.5, {});
  }
  make_older(folder.file());
  CaseBase base(folder.file());
  EXPECT_EQ(base.find(id).plan, numbered_case(1).plan);
  EXPECT_EQ(base.find(id).record.outcomes, 1U);
  base.record_outcome(id, 0.0, {{"Reach Way1", "field"}});
  EXPECT_EQ(base.find(id).record.failures.size(), 1U);
}

TEST(CaseBaseVersion, IsMigratedOnceByTwoProcessesAtOnce) {
  const Folder folder;
  { CaseBase(folder.file()).store(numbered_case(100)); }
  make_older(folder.file());
  const std::vector<pid_t> children{storing(folder.file(), 0, 3), storing(folder.file(), 3, 3)};
  for (const pid_t child : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(CaseBase(folder.file()).size(), 7U);
}

/// Three cases, the second of which is spoiled.
class SpoiledRow : public ::testing::TestWithParam<const char*> {};

TEST_P(SpoiledRow, IsNamedAndLeftOut) {
  const Folder folder;
  {
    CaseBase base(folder.file());
    for (int i = 1; i <= 3; ++i) base.store(numbered_case(i));
  }
  run_sql(folder.file(), GetParam());
  CaseBase base(folder.file());
  ASSERT_EQ(base.flaws().size(), 1U);
  EXPECT_EQ(base.flaws()[0].id, 2U);
  EXPECT_FALSE(base.flaws()[0].reason.empty());
  EXPECT_EQ(base.size(), 3U);
  ASSERT_EQ(base.heads().size(), 2U);
  EXPECT_EQ(base.heads()[1].id, 3U);
  EXPECT_EQ(base.listed().size(), 2U);
  EXPECT_THROW((void)base.find(2), ConfigError);
  EXPECT_EQ(base.find(3).plan, numbered_case(3).plan);
  base.remove(2);
  EXPECT_TRUE(base.flaws().empty());
}

INSTANTIATE_TEST_SUITE_P(
    Sample, SpoiledRow,
    ::testing::Values("UPDATE cases SET task = 77 WHERE id = 2",
                      "UPDATE cases SET robots = 0 WHERE id = 2",
                      "UPDATE cases SET environment = -1 WHERE id = 2",
                      "UPDATE cases SET plan = 'no mission' WHERE id = 2",
                      "UPDATE cases SET plan = substr(plan, 1, 200) WHERE id = 2"));

TEST(DamagedCaseBase, IsRefusedAndLeftAsItIs) {
  const Folder folder;
  {
    CaseBase base(folder.file());
    for (int i = 1; i <= 30; ++i) base.store(numbered_case(i));
  }
  std::string text = testing::text_of(folder.file());
  ASSERT_GT(text.size(), 20'000U);
  std::fill(text.begin() + 5000, text.end() - 5000, '\xA5');
  std::ofstream(folder.file(), std::ios::binary) << text;
  EXPECT_THROW(CaseBase base(folder.file()), ConfigError);
  EXPECT_EQ(testing::text_of(folder.file()), text);
}

/// All that a person sees of an answer, but for the numbers of the cases.
std::vector<std::string> told(const Answer& answer) {
  std::vector<std::string> lines;
  for (const Proposal& one : answer.proposals) {
    lines.push_back(std::to_string(one.offered.stars) + ' ' + one.offered.arrangement);
    lines.push_back(one.offered.mission);
    for (const UsedCase& used : one.offered.cases) lines.push_back(used.title + used.record);
  }
  return lines;
}

std::vector<std::string> answered(const std::vector<Case>& cases) {
  const Folder folder;
  CaseBase base(folder.file());
  base.store(cases);
  const Terrain terrain(
      read_overlay(testing::text_of(TACIT_SOURCE_DIR "/deploy/maps/office.ovl")).map);
  PlanRequest request;
  const MapPoint start = terrain.start();
  request.tasks.push_back({Task::Biohazard, start.x_m, start.y_m, {}, {}, {}});
  request.tasks.push_back({Task::Waypoints, start.x_m + 2.0, start.y_m, {}, {}, {}});
  request.top = 20;
  const CaseIndex index{base.heads()};
  return told(answer(request, terrain, index, base));
}

TEST(Answer, IsTheSameInWhateverOrderCasesWereStored) {
  std::vector<Case> cases{
      shipped_case("biohazard", Task::Biohazard), shipped_case("biohazard_pair", Task::Biohazard),
      shipped_case("eod", Task::ExplosiveOrdnance), numbered_case(1), numbered_case(2)};
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  const std::vector<std::string> wanted = answered(cases);
  ASSERT_GT(wanted.size(), 4U);
  while (std::next_permutation(order.begin(), order.end())) {
    std::vector<Case> permuted;
    for (const std::size_t i : order) permuted.push_back(cases[i]);
    ASSERT_EQ(answered(permuted), wanted);
  }
}

}  // namespace
}  // namespace tacit::cbr
