#include "console/record/run_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/wait.h>

#include "console/record/record_error.h"
#include "idl/types/config_error.h"
#include "tests/record/full_disk.h"
#include "tests/record/scratch.h"

namespace tacit {
namespace {

RunRow a_row(const std::string& key) {
  RunRow row;
  row.facts = {key, "0.1.0", "guard", -3, "one-process", 6, "lm", 4, {}, "2030-01-31T23:59:59Z"};
  row.outcome.complete = true;
  row.outcome.repeatable = true;
  row.outcome.ticks = 9000;
  row.outcome.events = 12;
  row.outcome.wall_s = 0.1;
  row.outcome.event_log_sha256 = "ab12";
  row.outcome.metrics = {{"created", std::uint64_t{7}}, {"mean_m", 0.1 + 0.2}, {"idle_m", {}}};
  row.run_dir = "/runs/" + key;
  return row;
}

class RunStoreTest : public ScratchTest {
 protected:
  const std::filesystem::path file = folder / "runs.db";
};

TEST_F(RunStoreTest, GivesARunBack) {
  RunStore(file).add(a_row("k"));

  EXPECT_EQ(RunStore(file).find("k"), a_row("k"));
}

TEST_F(RunStoreTest, KnowsNoRunThatWasNotAdded) {
  EXPECT_EQ(RunStore(file).find("k"), std::nullopt);
}

TEST_F(RunStoreTest, KeepsTheFirstOfTwoCompleteRunsWithOneKey) {
  RunStore store(file);
  RunRow second = a_row("k");
  second.outcome.ticks = 1;

  EXPECT_TRUE(store.add(a_row("k")));
  EXPECT_FALSE(store.add(second));
  EXPECT_EQ(store.find("k"), a_row("k"));
  EXPECT_EQ(store.size(), 1);
}

TEST_F(RunStoreTest, ReplacesAnIncompleteRun) {
  RunStore store(file);
  RunRow cut_short = a_row("k");
  cut_short.outcome.complete = false;
  cut_short.outcome.incomplete_because = "interrupted";

  EXPECT_TRUE(store.add(cut_short));
  EXPECT_TRUE(store.add(a_row("k")));
  EXPECT_EQ(store.find("k"), a_row("k"));
}

TEST_F(RunStoreTest, TellsWhichRunsAreFinished) {
  RunStore store(file);
  RunRow cut_short = a_row("b");
  cut_short.outcome.complete = false;
  store.add(a_row("c"));
  store.add(cut_short);
  store.add(a_row("a"));

  EXPECT_EQ(store.finished_keys(), (std::vector<std::string>{"a", "c"}));
}

TEST_F(RunStoreTest, TakesRowsFromSeveralProcessesAtOnce) {
  constexpr int kWriters = 4;
  constexpr int kRows = 40;
  std::vector<pid_t> children;
  for (int writer = 0; writer < kWriters; ++writer) {
    children.push_back(::fork());
    if (children.back() == 0) {
      RunStore store(file);
      for (int row = 0; row < kRows; ++row) {
        store.add(a_row(std::to_string(writer) + "/" + std::to_string(row)));
        store.add(a_row("shared/" + std::to_string(row)));
      }
      ::_exit(0);
    }
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(RunStore(file).size(), (kWriters + 1) * kRows);
}

TEST_F(RunStoreTest, ReadersDoNotWaitForAWriter) {
  RunStore(file).add(a_row("k"));
  SQLite::Database writer(file.string(), SQLite::OPEN_READWRITE);
  const SQLite::Transaction open(writer, SQLite::TransactionBehavior::IMMEDIATE);

  EXPECT_EQ(RunStore(file).size(), 1);
}

TEST_F(RunStoreTest, IsStrictAboutTypes) {
  RunStore(file).add(a_row("k"));
  SQLite::Database db(file.string(), SQLite::OPEN_READWRITE);

  EXPECT_THROW(db.exec("UPDATE runs SET ticks = 'many'"), SQLite::Exception);
}

TEST_F(RunStoreTest, RefusesAFileThatIsNoStore) {
  put(file, std::string(4096, 'x'));

  EXPECT_EQ(complaint<ConfigError>([&] { RunStore store(file); }),
            file.string() + ": is not an SQLite file, wanted a run store");
}

TEST_F(RunStoreTest, RefusesAStoreOfANewerVersion) {
  { RunStore store(file); }
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99");

  EXPECT_EQ(complaint<ConfigError>([&] { RunStore store(file); }),
            file.string() + ": has schema version 99, wanted at most 1");
}

TEST_F(RunStoreTest, NamesTheStoreThatCannotBeOpened) {
  const auto nowhere = folder / "none" / "runs.db";

  EXPECT_NE(complaint<RecordError>([&] { RunStore store(nowhere); }).find(nowhere.string()),
            std::string::npos);
}

TEST_F(RunStoreTest, KeepsItsRowsWhenTheDiskIsFull) {
  RunStore store(file);
  store.add(a_row("k"));
  {
    const FullDisk full(1);
    EXPECT_THROW(store.add(a_row("l")), RecordError);
  }
  EXPECT_EQ(store.find("k"), a_row("k"));
  EXPECT_TRUE(store.add(a_row("l")));
}

TEST(RepeatableKey, IsTheSameForTheSameRunOnly) {
  const std::string key = repeatable_key("robots = 6\n", 7, "0.1.0");

  EXPECT_EQ(repeatable_key("robots = 6\n", 7, "0.1.0"), key);
  EXPECT_NE(repeatable_key("robots = 5\n", 7, "0.1.0"), key);
  EXPECT_NE(repeatable_key("robots = 6\n", 8, "0.1.0"), key);
  EXPECT_NE(repeatable_key("robots = 6\n", 7, "0.2.0"), key);
}

}  // namespace
}  // namespace tacit
