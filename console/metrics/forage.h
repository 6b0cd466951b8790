#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "console/metrics/metric.h"
#include "idl/types/event.h"

namespace tacit {

/// How a forage mission goes (paper, section 3). Has metrics only in a run that is one.
struct Forage {
  std::optional<std::uint64_t> mines;  ///< To be stored, in all; absent in other missions.
  std::uint64_t stored = 0;
  std::uint64_t dropped = 0;  ///< Put down, or lost, outside the base.
  std::uint64_t stuck = 0;    ///< Times a robot was disabled by the terrain.
  std::uint64_t struck = 0;   ///< Times a robot was disabled by a hunter.
  std::uint64_t revived = 0;
  std::uint64_t hunters = 0;  ///< Times a hunter came out.
  std::uint64_t intercepted = 0;
  std::optional<MissionOver> end;

  void add(const Event& event);
  [[nodiscard]] std::uint64_t mines_left() const { return mines.value_or(0) - stored; }
  /// Robots that are out of action now.
  [[nodiscard]] std::uint64_t disabled() const { return stuck + struck - revived; }
  [[nodiscard]] std::vector<Metric> metrics() const;
};

}  // namespace tacit
