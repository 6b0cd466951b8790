#include "wizard_service/cases/case_file.h"

#include <array>
#include <chrono>
#include <thread>

namespace tacit::cbr {
namespace {

constexpr int kBusyMs = 30'000;

/// "TCas": tells a case base from other SQLite files.
constexpr int kApplicationId = 0x54436173;

/// Entry n brings a case base from version n to n + 1.
constexpr std::array kMigrations = {R"sql(
  CREATE TABLE cases (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    title TEXT NOT NULL,
    origin TEXT NOT NULL,
    task INTEGER NOT NULL,
    robots INTEGER NOT NULL,
    localization INTEGER NOT NULL,
    environment INTEGER NOT NULL,
    handles_enemy INTEGER NOT NULL,
    plan TEXT NOT NULL,
    plan_sum INTEGER NOT NULL,
    likeness TEXT NOT NULL,
    uses INTEGER NOT NULL,
    outcomes INTEGER NOT NULL,
    good_milli INTEGER NOT NULL,
    created TEXT NOT NULL,
    UNIQUE (likeness, task, robots, localization, environment, handles_enemy)
  ) STRICT;
)sql",
                                    R"sql(
  CREATE TABLE failures (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    case_id INTEGER NOT NULL REFERENCES cases (id) ON DELETE CASCADE,
    what TEXT NOT NULL,
    map TEXT NOT NULL
  ) STRICT;
  CREATE INDEX failures_by_case ON failures (case_id, number);
)sql",
                                    R"sql(
  CREATE TABLE reports (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    client INTEGER NOT NULL,
    request INTEGER NOT NULL,
    UNIQUE (client, request)
  ) STRICT;
)sql"};
constexpr int kNewest = static_cast<int>(kMigrations.size());

}  // namespace

CaseFile::CaseFile(const std::filesystem::path& file) : path_(file), db_(opened(file)) {
  attempt([&] {
    db_.setBusyTimeout(kBusyMs);
    refuse_others();
    refuse_damage();
    switch_to_wal();
    // With WAL anything less may lose the last commits when the power fails.
    db_.exec("PRAGMA synchronous = FULL");
    db_.exec("PRAGMA foreign_keys = ON");
    migrate();
  });
}

SQLite::Database CaseFile::opened(const std::filesystem::path& file) {
  return attempt(file, [&] {
    return SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  });
}

int CaseFile::number(const char* pragma) { return db_.execAndGet(pragma).getInt(); }

/// Before anything is written.
void CaseFile::refuse_others() {
  // One view of the file: another process may be making it just now.
  SQLite::Transaction view(db_);
  const bool empty = number("SELECT count(*) FROM sqlite_master") == 0;
  const int application = number("PRAGMA application_id");
  const int version = number("PRAGMA user_version");
  if (!(empty && application == 0 && version == 0) && application != kApplicationId) {
    throw ConfigError(path_.string() +
                      ": is an SQLite file for something else, wanted a case base");
  }
  if (version < 0 || version > kNewest) {
    throw ConfigError(path_.string() + ": has schema version " + std::to_string(version) +
                      ", wanted at most " + std::to_string(kNewest));
  }
}

void CaseFile::refuse_damage() {
  const std::string said = db_.execAndGet("PRAGMA quick_check(1)").getString();
  if (said != "ok") {
    throw ConfigError(path_.string() + ": is damaged, wanted a case base: " + said);
  }
}

/// The switch does not wait for other processes by itself.
void CaseFile::switch_to_wal() {
  constexpr int kPauseMs = 20;
  for (int waited_ms = 0;; waited_ms += kPauseMs) {
    try {
      db_.exec("PRAGMA journal_mode = WAL");
      return;
    } catch (const SQLite::Exception& error) {
      if (error.getErrorCode() != SQLITE_BUSY || waited_ms >= kBusyMs) throw;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(kPauseMs));
  }
}

void CaseFile::migrate() {
  if (number("PRAGMA user_version") == kNewest) return;
  SQLite::Transaction transaction(db_, SQLite::TransactionBehavior::IMMEDIATE);
  // Read again: another process may have been faster.
  for (int from = number("PRAGMA user_version"); from < kNewest; ++from) {
    db_.exec(kMigrations[static_cast<std::size_t>(from)]);
  }
  db_.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
  db_.exec("PRAGMA user_version = " + std::to_string(kNewest));
  transaction.commit();
}

}  // namespace tacit::cbr
