#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "console/metrics/tally.h"
#include "console/record/event_log.h"
#include "console/record/run.h"
#include "console/record/run_directory.h"
#include "console/record/trajectory_file.h"
#include "idl/types/event.h"
#include "idl/types/world_view.h"

namespace tacit {

/// Turns a run's stream of events into its run directory and its metrics.
///
/// In a directory in which a recorder has been before, it expects the events from the first on
/// again, as EventLog does, and ends with the same files.
class RunRecorder {
 public:
  enum class Trajectories : std::uint8_t { Off, On };

  /// Throws RecordError.
  explicit RunRecorder(RunDirectory directory, Trajectories trajectories = Trajectories::Off);

  /// Takes events of which the first is number `first` of the run, counted from 0. Those that have
  /// been taken are passed over. Throws RecordError when some before `first` are missing, and as
  /// EventLog::append.
  void add(std::uint64_t first, std::span<const Event> events);
  /// Takes the run's next events.
  void add(std::span<const Event> events) { add(log_.events(), events); }
  /// Does nothing when trajectories are off. Throws RecordError.
  void add(const WorldView& view);

  [[nodiscard]] const RunDirectory& directory() const { return directory_; }
  [[nodiscard]] const Tally& tally() const { return tally_; }
  /// How many have been taken.
  [[nodiscard]] std::uint64_t events() const { return log_.events(); }
  /// Whether the last event of the run has been taken.
  [[nodiscard]] bool ended() const { return tally_.of<Length>().complete; }

  /// Writes metrics.json and returns what it says. The run counts as complete when it has ended and
  /// `trouble` is empty; then all its files outlast the machine's power. One that is not, perhaps
  /// because somebody is in a hurry, does not wait for the disk. Throws RecordError.
  RunOutcome finish(double wall_s, const std::string& trouble = "");
  /// The run's row for a RunStore.
  [[nodiscard]] RunRow row(const RunOutcome& outcome) const;

 private:
  [[nodiscard]] RunOutcome outcome(double wall_s, const std::string& trouble) const;

  RunDirectory directory_;
  EventLog log_;
  std::optional<TrajectoryFile> trajectories_;
  Tally tally_;
};

}  // namespace tacit
