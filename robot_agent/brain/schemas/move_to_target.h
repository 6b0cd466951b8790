#pragma once

#include <string_view>

#include "idl/types/parameters.h"
#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls towards the target, the harder the farther it is: range / `unit_range_m`, at most
/// `max_push`; nothing nearer than `near_m`, or while the target was never seen.
class MoveToTarget final : public Schema {
 public:
  static constexpr std::string_view kName = "MoveToTarget";
  static constexpr std::string_view kKey = "move_to_target";

  struct Config {
    double unit_range_m = 25.0;  ///< Range at which the pull is 1; > 0.
    double max_push = 4.0;
    double near_m = 1.0;
  };
  explicit MoveToTarget(const Config& config) : config_(config) {}
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  Config config_;
};

void describe(MoveToTarget::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
