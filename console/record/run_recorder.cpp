#include "console/record/run_recorder.h"

#include <algorithm>
#include <utility>

#include "console/record/record_error.h"

namespace tacit {

RunRecorder::RunRecorder(RunDirectory directory, Trajectories trajectories)
    : directory_(std::move(directory)), log_(directory_.events_file()) {
  if (trajectories == Trajectories::On) {
    trajectories_.emplace(directory_.trajectories_file());
  }
}

void RunRecorder::add(std::uint64_t first, std::span<const Event> events) {
  const std::uint64_t next = log_.events();
  if (first > next) {
    throw RecordError(directory_.events_file(), "event " + std::to_string(first) +
                                                    " came, but event " + std::to_string(next) +
                                                    " is missing");
  }
  events = events.subspan(std::min<std::uint64_t>(next - first, events.size()));
  log_.append(events);
  for (const Event& event : events) {
    tally_.add(event);
  }
}

void RunRecorder::add(const WorldView& view) {
  if (trajectories_) {
    trajectories_->append(view);
  }
}

RunOutcome RunRecorder::finish(double wall_s, const std::string& trouble) {
  RunOutcome result = outcome(wall_s, trouble);
  directory_.write_outcome(result);
  if (result.complete) {
    directory_.sync();
  }
  return result;
}

RunRow RunRecorder::row(const RunOutcome& outcome) const {
  return {directory_.facts(), outcome, directory_.path().string()};
}

RunOutcome RunRecorder::outcome(double wall_s, const std::string& trouble) const {
  RunOutcome outcome;
  outcome.complete = ended() && !log_.expects_more() && trouble.empty();
  if (!outcome.complete) {
    outcome.incomplete_because = trouble.empty() ? "the end of the run was not recorded" : trouble;
  }
  outcome.repeatable = tally_.of<Absences>().repeatable();
  outcome.ticks = tally_.of<Length>().ticks;
  outcome.events = log_.events();
  outcome.wall_s = wall_s;
  outcome.event_log_sha256 = log_.sha256();
  outcome.metrics = recorded(tally_);
  return outcome;
}

}  // namespace tacit
