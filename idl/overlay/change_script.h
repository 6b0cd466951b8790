#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "idl/overlay/finding.h"

namespace tacit {

/// One obstacle comes or goes.
struct ObstacleChange {
  enum class Kind : std::uint8_t { Add, Remove };
  Kind kind = Kind::Add;
  MapObstacle obstacle;
  friend bool operator==(const ObstacleChange&, const ObstacleChange&) = default;
};

/// Obstacles come by chance in a rectangle.
struct RegionAdd {
  MapPoint from;
  MapPoint to;
  double cover_percent = 0.0;
  double least_radius_m = 0.0;
  double most_radius_m = 0.0;
  std::optional<std::int64_t> seed;
  std::optional<std::int64_t> increment;  ///< Of the seed, each time; only with a seed.
  friend bool operator==(const RegionAdd&, const RegionAdd&) = default;
};

/// All obstacles of a rectangle go.
struct RegionRemove {
  MapPoint from;
  MapPoint to;
  friend bool operator==(const RegionRemove&, const RegionRemove&) = default;
};

using Change = std::variant<ObstacleChange, RegionAdd, RegionRemove>;

/// Changes at a step, and every so many steps from then on when there is a period.
struct ChangeStep {
  std::int64_t start = 0;
  std::optional<std::int64_t> period;
  std::vector<Change> changes;
  friend bool operator==(const ChangeStep&, const ChangeStep&) = default;
};

/// How obstacles change while a mission runs: a MissionLab environment script.
using ChangeScript = std::vector<ChangeStep>;

struct ChangeReading {
  ChangeScript script;
  MapFindings findings;  ///< Errors only; a line with one is left out.
};

[[nodiscard]] ChangeReading read_changes(std::string_view text);

/// Reads back to an equal script.
[[nodiscard]] std::string to_text(const ChangeScript& script);

}  // namespace tacit
