#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "console/record/run_directory.h"
#include "console/tape/live_tape.h"
#include "deploy/lockstep/team.h"

namespace tacit {

/// The tape of a run in one process: the same channels as over DDS, by simulated time, so that the
/// file of a run made again differs in the wall time alone. World views of every tick; telemetry
/// and status once a simulated second.
class OneProcessTape {
 public:
  /// Throws McapError when `file` cannot be made.
  OneProcessTape(const std::filesystem::path& file, const RunDirectory& directory, Tick last_tick);

  /// Events of which the first is number `first` of the run.
  void add(std::uint64_t first, std::span<const Event> events);
  /// Records where the team stands after its step, of whose run there are `events` so far.
  void look(const Team& team, std::uint64_t events);
  void finish(const RunOutcome& outcome);

 private:
  template <class Word>
  void put(const Word& word);

  LiveTape tape_;
  Tick last_tick_;
  Tick per_second_;  ///< Ticks.
  EventBatch batch_;
  WorldView view_;
  Telemetry telemetry_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace tacit
