#include "deploy/tacit/one_process_tape.h"

#include <algorithm>
#include <cmath>

#include "console/record/files.h"
#include "console/tape/scenery.h"
#include "deploy/tacit/say.h"
#include "idl/bus/cdr.h"

namespace tacit {
namespace {

std::string scenario_of(const RunDirectory& directory) {
  return read_whole_file(directory.scenario_file());
}

Tick ticks_per_second(const RunDirectory& directory) {
  const double tick_s =
      scenery_of(scenario_of(directory), directory.scenario_file().string()).tick_s;
  return static_cast<Tick>(std::max(1.0, std::round(1.0 / tick_s)));
}

}  // namespace

OneProcessTape::OneProcessTape(const std::filesystem::path& file, const RunDirectory& directory,
                               Tick last_tick)
    : tape_(file, directory, say),
      last_tick_(last_tick),
      per_second_(ticks_per_second(directory)) {}

template <class Word>
void OneProcessTape::put(const Word& word) {
  to_cdr(word, bytes_);
  tape_.add(word, bytes_);
}

void OneProcessTape::add(std::uint64_t first, std::span<const Event> events) {
  while (!events.empty()) {
    const std::size_t count = std::min(events.size(), EventBatch::kMaxEvents);
    batch_.first = first;
    batch_.events.assign(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(count));
    put(batch_);
    first += count;
    events = events.subspan(count);
  }
}

void OneProcessTape::look(const Team& team, std::uint64_t events) {
  team.world().view(view_);
  put(view_);
  if (team.tick() % per_second_ != 0 && !team.done(last_tick_)) return;
  for (const Brain& brain : team.brains()) {
    brain.report(telemetry_);
    put(telemetry_);
  }
  RunStatus status;
  status.phase = team.done(last_tick_) ? RunPhase::Ended : RunPhase::Running;
  status.tick = team.tick();
  status.last_tick = last_tick_;
  status.events = events;
  status.robots = static_cast<std::uint16_t>(team.brains().size());
  status.present = status.robots;
  put(status);
}

void OneProcessTape::finish(const RunOutcome& outcome) { tape_.finish(outcome); }

}  // namespace tacit
