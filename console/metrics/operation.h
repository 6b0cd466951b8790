#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "console/metrics/metric.h"
#include "idl/types/event.h"

namespace tacit {

/// How an operation goes. Has metrics only in a run that is one.
struct Operation {
  std::optional<std::uint64_t> team;  ///< Robots of it; absent in other missions.
  std::uint64_t rooms = 0;            ///< Times a robot of the team came into a room.
  std::uint64_t tested = 0;
  std::uint64_t dangerous = 0;  ///< Of those.
  std::uint64_t stored = 0;     ///< Objects put into containers.
  std::uint64_t signals = 0;
  std::uint64_t alerts = 0;
  std::uint64_t exposures = 0;  ///< Times a robot of the team came into an enemy's sight.
  std::uint64_t finished = 0;   ///< Robots of the team that have nothing more to do.
  std::optional<MissionOver> end;

  void add(const Event& event);
  [[nodiscard]] std::vector<Metric> metrics() const;
};

}  // namespace tacit
