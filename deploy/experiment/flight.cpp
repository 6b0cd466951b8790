#include "deploy/experiment/flight.h"

#include <algorithm>

#include "console/debrief/debrief.h"
#include "deploy/lockstep/team.h"
#include "idl/overlay/plan.h"
#include "idl/overlay/reader.h"

namespace tacit {
namespace {

Debrief debrief_for(const Setup& setup) {
  const OperationScript& script = setup.world.operation.script;
  Debrief::Config config;
  config.team = script.starts.size() - static_cast<std::size_t>(script.extra_count);
  config.hostile = script.extra_count > 0 && script.extra_colour == "red";
  config.doors = setup.world.area.doors == "closed" ? Doors::Closed : Doors::Open;
  config.tick_s = setup.world.physics.tick_s;
  return {plan_of(read_overlay(script.map).map, config.doors), config};
}

}  // namespace

std::vector<std::string> Flight::failures() const {
  std::vector<std::string> failures;
  for (const SubTask& task : list.tasks) {
    if (!task.done) failures.push_back(task.name + ": " + task.evidence);
  }
  return failures;
}

std::optional<Estimate> score_estimate(std::span<const double> scores) {
  std::optional<Estimate> estimate = mean_estimate(scores);
  if (estimate) {
    estimate->low = std::max(0.0, estimate->low);
    estimate->high = std::min(1.0, estimate->high);
  }
  return estimate;
}

std::optional<Flight> fly(const Setup& setup, std::uint64_t seed, const std::stop_token& stop) {
  Team team(setup.world, setup.brain, seed);
  Debrief debrief = debrief_for(setup);
  while (!team.done(last_tick(setup))) {
    if (stop.stop_requested()) return std::nullopt;
    for (const Event& event : team.step()) debrief.add(event);
  }
  const double time_s = static_cast<double>(team.tick()) * setup.world.physics.tick_s;
  return Flight{seed, debrief.result(), time_s, team.world().over()};
}

}  // namespace tacit
