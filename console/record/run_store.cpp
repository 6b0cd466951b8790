#include "console/record/run_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <array>
#include <chrono>
#include <thread>

#include "console/record/json.h"
#include "console/record/record_error.h"
#include "console/record/sha256.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr int kBusyMs = 30'000;

/// Entry n brings a store from version n to n + 1.
constexpr std::array kMigrations = {R"sql(
  CREATE TABLE runs (
    key TEXT NOT NULL PRIMARY KEY,
    scenario TEXT NOT NULL,
    seed INTEGER NOT NULL,
    version TEXT NOT NULL,
    transport TEXT NOT NULL,
    robots INTEGER NOT NULL,
    learner TEXT NOT NULL,
    strategy INTEGER NOT NULL,
    started TEXT NOT NULL,
    complete INTEGER NOT NULL,
    incomplete_because TEXT NOT NULL,
    repeatable INTEGER NOT NULL,
    ticks INTEGER NOT NULL,
    events INTEGER NOT NULL,
    wall_s REAL NOT NULL,
    event_log_sha256 TEXT NOT NULL,
    metrics TEXT NOT NULL,
    run_dir TEXT NOT NULL
  ) STRICT, WITHOUT ROWID;
  CREATE INDEX runs_by_setting ON runs (scenario, learner, strategy, robots);
)sql"};

constexpr const char* kAdd = R"sql(
  INSERT INTO runs VALUES
    (:key, :scenario, :seed, :version, :transport, :robots, :learner, :strategy, :started,
     :complete, :incomplete_because, :repeatable, :ticks, :events, :wall_s, :event_log_sha256,
     :metrics, :run_dir)
  ON CONFLICT (key) DO UPDATE SET
    started = excluded.started, complete = excluded.complete,
    incomplete_because = excluded.incomplete_because, repeatable = excluded.repeatable,
    ticks = excluded.ticks, events = excluded.events, wall_s = excluded.wall_s,
    event_log_sha256 = excluded.event_log_sha256, metrics = excluded.metrics,
    run_dir = excluded.run_dir
  WHERE NOT runs.complete
)sql";

void bind(SQLite::Statement& statement, const RunFacts& facts) {
  statement.bind(":key", facts.key);
  statement.bind(":scenario", facts.scenario);
  statement.bind(":seed", facts.seed);
  statement.bind(":version", facts.version);
  statement.bind(":transport", facts.transport);
  statement.bind(":robots", facts.robots);
  statement.bind(":learner", facts.learner);
  statement.bind(":strategy", facts.strategy);
  statement.bind(":started", facts.started);
}

void bind(SQLite::Statement& statement, const RunOutcome& outcome) {
  statement.bind(":complete", outcome.complete ? 1 : 0);
  statement.bind(":incomplete_because", outcome.incomplete_because);
  statement.bind(":repeatable", outcome.repeatable ? 1 : 0);
  statement.bind(":ticks", static_cast<std::int64_t>(outcome.ticks));
  statement.bind(":events", static_cast<std::int64_t>(outcome.events));
  statement.bind(":wall_s", outcome.wall_s);
  statement.bind(":event_log_sha256", outcome.event_log_sha256);
  statement.bind(":metrics", to_json(outcome.metrics));
}

RunFacts facts_of(SQLite::Statement& found) {
  RunFacts facts;
  facts.key = found.getColumn("key").getString();
  facts.scenario = found.getColumn("scenario").getString();
  facts.seed = found.getColumn("seed").getInt64();
  facts.version = found.getColumn("version").getString();
  facts.transport = found.getColumn("transport").getString();
  facts.robots = found.getColumn("robots").getInt64();
  facts.learner = found.getColumn("learner").getString();
  facts.strategy = found.getColumn("strategy").getInt64();
  facts.started = found.getColumn("started").getString();
  return facts;
}

RunOutcome outcome_of(SQLite::Statement& found, const std::string& where) {
  RunOutcome outcome;
  outcome.complete = found.getColumn("complete").getInt() != 0;
  outcome.incomplete_because = found.getColumn("incomplete_because").getString();
  outcome.repeatable = found.getColumn("repeatable").getInt() != 0;
  outcome.ticks = static_cast<Tick>(found.getColumn("ticks").getInt64());
  outcome.events = static_cast<std::uint64_t>(found.getColumn("events").getInt64());
  outcome.wall_s = found.getColumn("wall_s").getDouble();
  outcome.event_log_sha256 = found.getColumn("event_log_sha256").getString();
  outcome.metrics = metrics_from_json(found.getColumn("metrics").getString(), where);
  return outcome;
}

/// Runs `work`, with SQLite's errors as ours.
template <class Work>
auto attempt(const std::filesystem::path& file, Work work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() == SQLITE_NOTADB) {
      throw ConfigError(file.string() + ": is not an SQLite file, wanted a run store");
    }
    throw RecordError(file, error.what());
  }
}

SQLite::Database opened(const std::filesystem::path& file) {
  return attempt(file, [&] {
    return SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  });
}

}  // namespace

class RunStore::Impl {
 public:
  explicit Impl(const std::filesystem::path& file) : path_(file), db_(opened(file)) {
    attempt(path_, [&] {
      db_.setBusyTimeout(kBusyMs);
      switch_to_wal();
      // With WAL this loses at most the last rows when the power fails, and nothing when only the
      // process dies.
      db_.exec("PRAGMA synchronous = NORMAL");
      migrate();
    });
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] SQLite::Database& db() { return db_; }

 private:
  /// The switch does not wait for other processes by itself.
  void switch_to_wal() {
    constexpr int kPauseMs = 20;
    for (int waited_ms = 0;; waited_ms += kPauseMs) {
      try {
        db_.exec("PRAGMA journal_mode = WAL");
        return;
      } catch (const SQLite::Exception& error) {
        if (error.getErrorCode() != SQLITE_BUSY || waited_ms >= kBusyMs) {
          throw;
        }
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(kPauseMs));
    }
  }

  int version() { return db_.execAndGet("PRAGMA user_version").getInt(); }

  void migrate() {
    constexpr int kNewest = static_cast<int>(kMigrations.size());
    if (version() == kNewest) {
      return;
    }
    SQLite::Transaction transaction(db_, SQLite::TransactionBehavior::IMMEDIATE);
    // Read again: another process may have been faster.
    const int oldest = version();
    if (oldest < 0 || oldest > kNewest) {
      throw ConfigError(path_.string() + ": has schema version " + std::to_string(oldest) +
                        ", wanted at most " + std::to_string(kNewest));
    }
    for (int from = oldest; from < kNewest; ++from) {
      db_.exec(kMigrations[static_cast<std::size_t>(from)]);
    }
    db_.exec("PRAGMA user_version = " + std::to_string(kNewest));
    transaction.commit();
  }

  std::filesystem::path path_;
  SQLite::Database db_;
};

RunStore::RunStore(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {}
RunStore::~RunStore() = default;
RunStore::RunStore(RunStore&&) noexcept = default;
RunStore& RunStore::operator=(RunStore&&) noexcept = default;

bool RunStore::add(const RunRow& row) {
  return attempt(impl_->path(), [&] {
    SQLite::Statement statement(impl_->db(), kAdd);
    bind(statement, row.facts);
    bind(statement, row.outcome);
    statement.bind(":run_dir", row.run_dir);
    return statement.exec() > 0;
  });
}

std::optional<RunRow> RunStore::find(std::string_view key) const {
  return attempt(impl_->path(), [&]() -> std::optional<RunRow> {
    SQLite::Statement found(impl_->db(), "SELECT * FROM runs WHERE key = ?");
    found.bind(1, std::string(key));
    if (!found.executeStep()) {
      return std::nullopt;
    }
    const std::string where = impl_->path().string() + ": metrics of run " + std::string(key);
    return RunRow{facts_of(found), outcome_of(found, where),
                  found.getColumn("run_dir").getString()};
  });
}

std::vector<std::string> RunStore::finished_keys() const {
  return attempt(impl_->path(), [&] {
    std::vector<std::string> keys;
    SQLite::Statement found(impl_->db(), "SELECT key FROM runs WHERE complete ORDER BY key");
    while (found.executeStep()) {
      keys.push_back(found.getColumn(0).getString());
    }
    return keys;
  });
}

std::uint64_t RunStore::size() const {
  return attempt(impl_->path(), [&] {
    const auto count = impl_->db().execAndGet("SELECT count(*) FROM runs").getInt64();
    return static_cast<std::uint64_t>(count);
  });
}

std::string repeatable_key(std::string_view scenario_toml, std::int64_t seed,
                           std::string_view version) {
  Sha256 hash;
  hash.add(std::string(version) + '\n' + std::to_string(seed) + '\n');
  hash.add(scenario_toml);
  return hash.hex();
}

}  // namespace tacit
