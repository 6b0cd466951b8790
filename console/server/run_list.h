#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "console/live/live_run.h"
#include "console/record/run_directory.h"

namespace tacit {

/// The runs in a folder of run directories.
class RunList {
 public:
  /// The newest, and how many.
  static constexpr std::size_t kMost = 500;

  explicit RunList(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// A name that may stand for a run: of letters, digits, `-`, `_` and `.`, not with a dot first.
  [[nodiscard]] static bool is_id(const std::string& id);
  /// Throws ConfigError when there is no such run.
  [[nodiscard]] RunDirectory open(const std::string& id) const;
  /// What is needed to watch it; none when it is not going on.
  [[nodiscard]] std::optional<LiveRunFacts> live(const std::string& id) const;
  /// Ids of runs that say that they are going on.
  [[nodiscard]] std::vector<std::string> live_ids() const;

  /// A JSON array, the newest first: `id`, `name`, `scenario`, `seed`, `state` ("live", "done",
  /// "stopped", "failed"), `started`, `ticks`, `robots`, `recording` and `score`.
  [[nodiscard]] std::string to_json() const;
  /// One of them, with `metrics`, and `checklist` when that was given as JSON.
  [[nodiscard]] std::string to_json(const std::string& id, const std::string& checklist) const;
  /// Whether its result stands.
  [[nodiscard]] bool is_over(const std::string& id) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace tacit
