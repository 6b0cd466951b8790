#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "wizard_service/cbr/case.h"

namespace tacit::cbr {

/// A row that cannot be used, and why.
struct Flaw {
  CaseId id = 0;
  std::string reason;
  friend bool operator==(const Flaw&, const Flaw&) = default;
};

/// All rows of a case base, by id.
struct Inventory {
  std::vector<CaseHead> heads;  ///< Of the cases that can be used.
  std::vector<Flaw> flaws;      ///< The rows that cannot.
};

/// Where a case was put.
struct Stored {
  CaseId id = 0;
  bool fresh = true;  ///< False: it was there; nothing changed.
  friend bool operator==(const Stored&, const Stored&) = default;
};

/// By which a report is told from others: who made it, and the how manyth of its requests it was.
struct ReportKey {
  std::uint64_t client = 0;
  std::uint64_t request = 0;
};
/// Reports that are remembered, the newest, so that one that comes again is known.
inline constexpr int kReportsKept = 10'000;

/// Cases in one SQLite file.
///
/// What `store`, `record_outcome`, `record_report` or `remove` has returned for is on
/// the disk: neither the death of a process nor a loss of power takes it away. Several processes
/// and threads may use one file at once, each through a CaseBase of its own; one CaseBase is for
/// one thread at a time.
///
/// All of it throws CaseBaseError when the file cannot be read or written and ConfigError when it
/// is damaged or when no case has the id.
class CaseBase final : public CaseSource {
 public:
  /// Opens or creates `file` and brings an older schema up to date. Throws ConfigError, and leaves
  /// the file as it is, when it is no case base, a damaged one or one of a newer version.
  explicit CaseBase(const std::filesystem::path& file);
  ~CaseBase() override;

  /// Two cases of the same features and likeness are the same case: the second is not kept.
  Stored store(const Case& one);
  /// All or none of them, in their order.
  std::vector<Stored> store(std::span<const Case> cases);

  /// The reference holds until kCasesKept others have been found. A record is always the newest.
  [[nodiscard]] const Case& find(CaseId id) override;
  /// Both parts at once; each row is read once.
  [[nodiscard]] Inventory inventory();
  [[nodiscard]] std::vector<CaseHead> heads();
  /// The same with titles and records, without plans.
  [[nodiscard]] std::vector<Case> listed();
  [[nodiscard]] std::vector<Flaw> flaws();

  /// Takes in how a use went: `score` 0 to 1, and what failed.
  void record_outcome(CaseId id, double score, const std::vector<Failure>& failures);
  /// The same, and a use, for each of `cases` that is still there, once for each key: false, and
  /// nothing changes, when a report of this key was taken in before. Throws ConfigError when none
  /// of the cases is there.
  bool record_report(const ReportKey& by, std::span<const CaseId> cases, double score,
                     const std::vector<Failure>& failures);
  void remove(CaseId id);

  /// Rows, usable or not.
  [[nodiscard]] std::uint64_t size();
  /// Whether a case was ever stored, also one that was removed.
  [[nodiscard]] bool was_used();
  /// Whether anybody changed anything since this was asked last; true the first time.
  [[nodiscard]] bool changed_since_last_look();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Cases whose plans are kept in memory.
inline constexpr std::size_t kCasesKept = 64;

}  // namespace tacit::cbr
