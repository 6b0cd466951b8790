#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "idl/types/ids.h"

namespace tacit {

/// How far a run has come.
struct Progress {
  Tick tick = 0;
  Tick last_tick = 0;      ///< At which it will end; 0 while that is not known.
  double tick_s = 0.0;     ///< Simulated time per tick.
  double ticks_per_s = 0;  ///< Of wall time; 0 while that is not known.
  std::uint64_t created = 0;
  std::uint64_t intercepted = 0;
  std::uint64_t successful = 0;
};

/// One line for people: tick, time left, speed (and how many times real time), enemies.
[[nodiscard]] std::string progress_text(const Progress& progress);

/// Wall time to the end of the run; absent while the speed or the end is not known.
[[nodiscard]] std::optional<double> seconds_left(const Progress& progress);

/// "0:07", "12:30", "3:05:00".
[[nodiscard]] std::string clock_text(double seconds);

}  // namespace tacit
