#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "console/metrics/tally.h"
#include "idl/types/ids.h"
#include "idl/types/telemetry.h"

namespace tacit {

/// How far a run has come.
struct Progress {
  Tick tick = 0;
  Tick last_tick = 0;      ///< At which it will end; 0 while that is not known.
  double tick_s = 0.0;     ///< Simulated time per tick.
  double ticks_per_s = 0;  ///< Of wall time; 0 while that is not known.
  std::string standing;    ///< As `standing_text` words it.
};

/// How the mission stands, in a few words: enemies, or mines and able robots; then, in brackets,
/// what the robots are at, if they are at anything. `robots` is the size of the team, `doings` is
/// as `doings_text` words it.
[[nodiscard]] std::string standing_text(const Tally& tally, std::int64_t robots,
                                        const std::string& doings = {});

/// What a brain is at: its role, or the situation that it sees itself in; may be empty.
[[nodiscard]] const std::string& doing(const Telemetry& telemetry);
/// "3 Forager, 1 Soldier": how many robots are at what; those with an empty text do not count.
[[nodiscard]] std::string doings_text(const std::map<RobotId, std::string>& doings);

/// One line for people: tick, time left, speed (and how many times real time), standing.
[[nodiscard]] std::string progress_text(const Progress& progress);

/// Wall time to the end of the run; absent while the speed or the end is not known.
[[nodiscard]] std::optional<double> seconds_left(const Progress& progress);

/// "0:07", "12:30", "3:05:00".
[[nodiscard]] std::string clock_text(double seconds);

}  // namespace tacit
