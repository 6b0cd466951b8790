#pragma once

#include "idl/scenario/run_config.h"
#include "idl/scenario/scenario_file.h"
#include "idl/types/ids.h"
#include "robot_agent/brain/brain_config.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// A whole scenario: all that a run is made from.
struct Setup {
  RunConfig run;
  WorldConfig world;
  BrainConfig brain;
};

/// The defaults for a mission.
[[nodiscard]] Setup setup_for(MissionKind mission);

/// Every parameter of a scenario, section by section.
void describe(Setup& setup, ParameterVisitor& visitor);

/// Takes what `file` says over the defaults, and a map that it names into the world. Throws
/// ConfigError on anything that cannot be, unknown keys and sections included.
[[nodiscard]] Setup read_setup(ScenarioFile& file);

/// The tick at which the run ends.
[[nodiscard]] Tick last_tick(const Setup& setup);

/// The attack strategy; 0 in a mission without one.
[[nodiscard]] std::int64_t strategy(const Setup& setup);

/// The scenario's seed as the random streams take it.
[[nodiscard]] inline std::uint64_t seed(const Setup& setup) {
  return static_cast<std::uint64_t>(setup.run.seed);
}

}  // namespace tacit
