#pragma once

#include <cstdint>
#include <string>

#include "idl/types/ids.h"
#include "idl/types/mission_kind.h"
#include "idl/types/parameters.h"

namespace tacit {

/// What a run is called, how long it lasts and which chance it draws.
struct RunConfig {
  std::string name = "unnamed";
  std::string description;
  std::string mission = "guard";  ///< One of `kMissionNames`.
  std::int64_t seed = 1;
  double duration_s = 900.0;  ///< Simulated.
};

[[nodiscard]] inline MissionKind mission_kind(const RunConfig& config) {
  return mission_kind(config.mission);
}

/// Sections `scenario` and `run`.
void describe(RunConfig& config, ParameterVisitor& visitor);

/// The tick at which a run of `duration_s` ends when a tick takes `tick_s`.
[[nodiscard]] Tick last_tick(double duration_s, double tick_s);

}  // namespace tacit
