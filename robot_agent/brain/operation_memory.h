#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "robot_agent/brain/fsa/record.h"
#include "robot_agent/brain/perception/operation_perception.h"

namespace tacit {

/// Where a robot of an operation stands in the middle of a run.
struct OperationStand {
  bool begun = false;
  OperationPerception::Memory perception;
  std::optional<OdometryVec> proceeded;  ///< See `Errand`.
  Record record;                         ///< Of its behaviours.
};

/// Lines of numbers, in the shortest form that reads back to the same bits.
[[nodiscard]] std::string to_text(const OperationStand& stand);
/// The inverse; empty for any other text.
[[nodiscard]] std::optional<OperationStand> parse_operation_stand(std::string_view text);

}  // namespace tacit
