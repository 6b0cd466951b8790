#pragma once

#include <optional>
#include <vector>

#include "console/metrics/metric.h"
#include "idl/types/event.h"

namespace tacit {

/// How the team stands when there is nothing to do: a stable team stays close and still.
///
/// Looks at the checkpoints without enemies, and of these at the later half (the middle one
/// included), so that the way to the resting place does not count.
class IdleSpread {
 public:
  void add(const Event& event);

  /// Mean distance of the robots to the target; absent without an idle checkpoint.
  [[nodiscard]] std::optional<double> mean_distance_m() const;
  /// Standard deviation over time of that distance; absent below two checkpoints.
  [[nodiscard]] std::optional<double> sd_distance_m() const;
  [[nodiscard]] std::optional<double> mean_speed_mps() const;
  [[nodiscard]] std::vector<Metric> metrics() const;

 private:
  [[nodiscard]] std::size_t settled() const { return distance_m_.size() / 2; }

  std::vector<double> distance_m_;
  std::vector<double> speed_mps_;
};

}  // namespace tacit
