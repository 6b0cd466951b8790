#pragma once

#include <cstdint>
#include <vector>

#include "console/metrics/metric.h"
#include "idl/types/event.h"

namespace tacit {

/// Touches that began; a long touch counts once.
struct Collisions {
  std::uint64_t count = 0;

  void add(const Event& event);
  [[nodiscard]] std::vector<Metric> metrics() const;
};

/// Robots whose agents failed them. Such a run cannot be made again bit for bit.
struct Absences {
  std::uint64_t lost = 0;
  std::uint64_t back = 0;
  std::uint64_t late = 0;

  void add(const Event& event);
  [[nodiscard]] bool repeatable() const { return lost == 0 && late == 0; }
  [[nodiscard]] std::vector<Metric> metrics() const;
};

/// How far the run has come.
struct Length {
  Tick ticks = 0;         ///< The tick of the newest event.
  bool complete = false;  ///< The world has said that the run is over.

  void add(const Event& event);
  /// None: the length is a fact of the run, told beside its metrics.
  [[nodiscard]] static std::vector<Metric> metrics() { return {}; }
};

}  // namespace tacit
