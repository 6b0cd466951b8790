#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "console/debrief/debrief.h"
#include "deploy/lockstep/operation_setup.h"
#include "deploy/lockstep/team.h"
#include "idl/overlay/plan.h"
#include "idl/overlay/reader.h"

namespace tacit::testing {

inline NamedText named_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()},
          file.filename().string()};
}

/// A mission and a map that ship.
inline NamedText shipped_mission(const std::string& name) {
  return named_text(std::filesystem::path(TACIT_SOURCE_DIR "/deploy/missions") / (name + ".cdl"));
}
inline NamedText shipped_map(const std::string& name) {
  return named_text(std::filesystem::path(TACIT_SOURCE_DIR "/deploy/maps") / (name + ".ovl"));
}

/// What an operation came to.
struct Outcome {
  std::vector<Event> events;
  Checklist list;
  Tick ticks = 0;
  bool over = false;  ///< Before its time was out.

  [[nodiscard]] std::string told() const {
    std::string text;
    for (const SubTask& task : list.tasks) {
      text += std::string(task.done ? "[x] " : "[ ] ") + task.name + ": " + task.evidence + "\n";
    }
    return text;
  }
};

/// Carries an operation out in one process, for at most `last_tick` ticks.
inline Outcome carry_out(const OperationWish& wish, std::uint64_t seed, Tick last_tick = 36'000) {
  const Setup setup = operation_setup(wish);
  const OperationScript& script = setup.world.operation.script;
  Team team(setup.world, setup.brain, seed);
  Debrief::Config config;
  config.team = script.starts.size() - static_cast<std::size_t>(script.extra_count);
  config.hostile = script.extra_count > 0 && script.extra_colour == "red";
  Debrief debrief(plan_of(read_overlay(script.map).map, Doors::Open), config);
  Outcome outcome;
  while (!team.done(last_tick)) {
    for (const Event& event : team.step()) {
      debrief.add(event);
      outcome.events.push_back(event);
    }
  }
  outcome.list = debrief.result();
  outcome.ticks = team.tick();
  outcome.over = team.world().over();
  return outcome;
}

}  // namespace tacit::testing
