#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "console/debrief/checklist.h"
#include "console/report/estimate.h"
#include "deploy/lockstep/setup.h"

namespace tacit {

/// What became of an operation that was carried out once, in this process.
struct Flight {
  std::uint64_t seed = 0;
  Checklist list;
  double time_s = 0.0;  ///< Simulated, until it ended.
  bool over = false;    ///< It ended by itself, before its time was out.

  /// Whether every sub-task was done.
  [[nodiscard]] bool full() const { return list.done() == list.wanted(); }
  /// Of each sub-task that was not done its name and why: "Enter Library: No robot was there."
  [[nodiscard]] std::vector<std::string> failures() const;
};

/// Carries out the operation that `setup` is, with `seed` instead of its own. The same setup and
/// seed give the same flight. Returns nothing when told to stop before its end. Throws ConfigError
/// when the setup cannot be.
[[nodiscard]] std::optional<Flight> fly(const Setup& setup, std::uint64_t seed,
                                        const std::stop_token& stop);

/// The mean of scores with its Student-t interval, which ends at 0 and 1; absent below two.
[[nodiscard]] std::optional<Estimate> score_estimate(std::span<const double> scores);

}  // namespace tacit
