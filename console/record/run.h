#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "console/metrics/tally.h"
#include "idl/types/ids.h"

namespace tacit {

/// What is known of a run before its first tick.
struct RunFacts {
  /// Two runs with the same key are the same run. Empty: made up when the run directory is.
  std::string key;
  std::string version;
  std::string scenario;  ///< Its name.
  std::int64_t seed = 0;
  std::string transport;  ///< "dds" or "one-process".
  std::int64_t robots = 0;
  std::string learner;
  std::int64_t strategy = 0;
  std::vector<std::string> command_line;
  std::string started;  ///< UTC, as utc_now().
  friend bool operator==(const RunFacts&, const RunFacts&) = default;
};

/// A metric as it is recorded; a value that was absent stays so.
struct RecordedMetric {
  std::string key;
  std::optional<std::variant<std::uint64_t, double>> value;
  friend bool operator==(const RecordedMetric&, const RecordedMetric&) = default;
};

/// What came out of a run.
struct RunOutcome {
  bool complete = false;           ///< The run reached its end and every event of it is recorded.
  std::string incomplete_because;  ///< Empty when complete.
  bool repeatable = false;         ///< No robot was lost or late, no operator acted.
  Tick ticks = 0;
  std::uint64_t events = 0;
  double wall_s = 0.0;
  std::string event_log_sha256;
  std::vector<RecordedMetric> metrics;

  /// Absent when no time was measured.
  [[nodiscard]] std::optional<double> ticks_per_s() const {
    return wall_s > 0.0 ? std::optional(static_cast<double>(ticks) / wall_s) : std::nullopt;
  }
  /// Absent also when there is no metric `key`.
  [[nodiscard]] std::optional<double> metric(std::string_view key) const;
  friend bool operator==(const RunOutcome&, const RunOutcome&) = default;
};

/// A run in a store of many; the store leaves out the command line.
struct RunRow {
  RunFacts facts;
  RunOutcome outcome;
  std::string run_dir;  ///< Empty when nothing but this row is kept.
  friend bool operator==(const RunRow&, const RunRow&) = default;
};

/// The tally's metrics as they are recorded.
[[nodiscard]] std::vector<RecordedMetric> recorded(const Tally& tally);

/// Now, as "2030-01-31T23:59:59Z".
[[nodiscard]] std::string utc_now();

}  // namespace tacit
