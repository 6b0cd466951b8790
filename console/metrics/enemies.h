#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "console/metrics/metric.h"
#include "idl/types/event.h"

namespace tacit {

/// What became of the normal enemies.
struct Enemies {
  std::uint64_t created = 0;
  std::uint64_t intercepted = 0;  ///< Destroyed by a robot.
  std::uint64_t successful = 0;   ///< Reached the target.

  void add(const Event& event);
  /// Share of the intercepted among those whose fate is known, in percent.
  [[nodiscard]] std::optional<double> intercept_percent() const;
  [[nodiscard]] std::vector<Metric> metrics() const;
};

/// How far from the target the normal enemies died; a successful one counts at the distance at
/// which it hit. This is the P(n) of the improvement ratio.
struct DeathDistance {
  std::uint64_t deaths = 0;
  double sum_m = 0.0;

  void add(const Event& event);
  [[nodiscard]] std::optional<double> mean_m() const;
  [[nodiscard]] std::vector<Metric> metrics() const;
};

/// Decoys, which count in no other figure.
struct Decoys {
  std::uint64_t created = 0;
  std::uint64_t intercepted = 0;

  void add(const Event& event);
  [[nodiscard]] std::vector<Metric> metrics() const;
};

}  // namespace tacit
