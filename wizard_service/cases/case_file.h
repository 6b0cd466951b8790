#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>

#include "idl/types/config_error.h"
#include "wizard_service/cases/case_base_error.h"

namespace tacit::cbr {

/// The SQLite file of a case base, opened, known to be one and of the newest schema.
class CaseFile {
 public:
  /// Throws as the constructor of CaseBase does.
  explicit CaseFile(const std::filesystem::path& file);

  [[nodiscard]] SQLite::Database& db() { return db_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Runs `work`, with SQLite's errors as ours.
  template <class Work>
  decltype(auto) attempt(Work work) const {
    return attempt(path_, work);
  }

 private:
  template <class Work>
  static decltype(auto) attempt(const std::filesystem::path& file, Work work) {
    try {
      return work();
    } catch (const SQLite::Exception& error) {
      if (error.getErrorCode() == SQLITE_NOTADB) {
        throw ConfigError(file.string() + ": is not an SQLite file, wanted a case base");
      }
      if (error.getErrorCode() == SQLITE_CORRUPT) {
        throw ConfigError(file.string() + ": is damaged, wanted a case base: " + error.what());
      }
      throw CaseBaseError(file, error.what());
    }
  }
  static SQLite::Database opened(const std::filesystem::path& file);

  void refuse_others();
  void refuse_damage();
  void switch_to_wal();
  void migrate();
  [[nodiscard]] int number(const char* pragma);

  std::filesystem::path path_;
  SQLite::Database db_;
};

}  // namespace tacit::cbr
