#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "console/record/run.h"

namespace tacit {

/// Many runs in one SQLite file, a row each. Several processes may write to it at once.
class RunStore {
 public:
  /// Opens or creates `file` and brings an older schema up to date. Throws ConfigError when it is
  /// no run store or one of a newer version, RecordError when it cannot be read or written.
  explicit RunStore(const std::filesystem::path& file);
  ~RunStore();
  RunStore(RunStore&&) noexcept;
  RunStore& operator=(RunStore&&) noexcept;

  /// Adds the run, or replaces an incomplete one of the same key. Returns false, and changes
  /// nothing, when a complete run of that key is there. Throws RecordError.
  bool add(const RunRow& row);

  [[nodiscard]] std::optional<RunRow> find(std::string_view key) const;
  /// Keys of complete runs, ascending.
  [[nodiscard]] std::vector<std::string> finished_keys() const;
  [[nodiscard]] std::uint64_t size() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The key under which a run is found again: the same scenario, seed and version give the same
/// run. For sets of runs that are resumed; `scenario_toml` is the scenario as resolved.
[[nodiscard]] std::string repeatable_key(std::string_view scenario_toml, std::int64_t seed,
                                         std::string_view version);

}  // namespace tacit
