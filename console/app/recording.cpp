#include "console/app/recording.h"

#include "console/app/stop_signals.h"
#include "console/record/record_error.h"
#include "console/report/progress_text.h"

namespace tacit {
namespace {

/// How long to wait, after the last event, for the world's last status and views.
constexpr std::chrono::seconds kSettling{3};
/// Over which the speed is measured.
constexpr double kPaceWindow_s = 3.0;

}  // namespace

Recording::Recording(RunListener& listener, RunRecorder& recorder, LiveTape& tape, StatusLine& line,
                     Setting setting)
    : listener_(listener), recorder_(recorder), tape_(tape), line_(line), setting_(setting) {}

std::optional<Ending> Recording::round() {
  std::optional<Ending> end;
  try {
    take();
    end = ending();
  } catch (const RecordError& error) {
    end = Ending{ExitCode::NotRecorded, error.what()};
  }
  if (end) {
    end->wall_s = status_.wall_s;
    line_.show_now(standing());
    line_.end();
  } else if (has_status_) {
    line_.show(standing());
  }
  return end;
}

std::optional<Ending> Recording::ending() {
  if (recorder_.ended() && settled()) {
    return Ending{};
  }
  if (StopSignals::came()) {
    return Ending{ExitCode::Interrupted, "interrupted"};
  }
  const std::string tick = "tick " + std::to_string(status_.tick);
  if (status_.phase == RunPhase::Stopped && recorder_.events() >= status_.events) {
    return Ending{ExitCode::Interrupted, "the run was stopped at " + tick};
  }
  if (Clock::now() - heard_ > setting_.patience) {
    return Ending{ExitCode::WorldVanished, has_status_
                                               ? "the world has vanished, last heard of at " + tick
                                               : "the world has never been heard of"};
  }
  return std::nullopt;
}

void Recording::take() {
  listener_.events([&](const EventBatch& batch, RunListener::Bytes bytes) {
    recorder_.add(batch.first, batch.events);
    heard_ = Clock::now();
    tape_.add(batch, bytes);
  });
  listener_.views([&](const WorldView& view, RunListener::Bytes bytes) {
    recorder_.add(view);
    newest_view_ = view.tick;
    tape_.add(view, bytes);
  });
  listener_.status([&](const RunStatus& status, RunListener::Bytes bytes) {
    hear(status);
    tape_.add(status, bytes);
  });
  listener_.telemetry(
      [&](const Telemetry& telemetry, RunListener::Bytes bytes) { tape_.add(telemetry, bytes); });
  tape_.keep();
  if (recorder_.ended() && !ended_) {
    ended_ = Clock::now();
  }
}

void Recording::hear(const RunStatus& status) {
  status_ = status;
  has_status_ = true;
  heard_ = Clock::now();
  pace_.emplace_back(status.wall_s, status.tick);
  while (pace_.size() > 2 && pace_.back().first - pace_.front().first > kPaceWindow_s) {
    pace_.pop_front();
  }
}

std::string Recording::standing() {
  if (status_.phase == RunPhase::Gathering) {
    return "waiting for robots, " + std::to_string(status_.present) + " of " +
           std::to_string(status_.robots) + " are there";
  }
  return progress_text({status_.tick, status_.last_tick, setting_.tick_s, ticks_per_s(),
                        standing_text(recorder_.tally(), recorder_.directory().facts().robots,
                                      listener_.doings())}) +
         (status_.phase == RunPhase::Paused ? "  paused" : "");
}

bool Recording::settled() const {
  return (status_.phase == RunPhase::Ended && all_viewed()) || Clock::now() - *ended_ > kSettling;
}

bool Recording::all_viewed() const {
  return !setting_.trajectories || newest_view_ >= status_.tick;
}

double Recording::ticks_per_s() const {
  if (pace_.size() < 2 || pace_.back().first <= pace_.front().first) {
    return 0.0;
  }
  return static_cast<double>(pace_.back().second - pace_.front().second) /
         (pace_.back().first - pace_.front().first);
}

}  // namespace tacit
