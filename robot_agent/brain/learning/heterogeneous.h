#pragma once

#include "idl/types/ids.h"
#include "idl/types/parameters.h"
#include "robot_agent/brain/learning/role_selector.h"

namespace tacit {

/// The paper's heterogeneous team: every robot has a role for good, by its number alone. A pattern
/// of so many foragers, soldiers and mechanics is laid over the numbers again and again.
class Heterogeneous final : public RoleSelector {
 public:
  struct Config {
    std::int64_t foragers = 2;
    std::int64_t soldiers = 1;
    std::int64_t mechanics = 1;
  };
  /// Throws ConfigError when the pattern is empty.
  Heterogeneous(const Config& config, RobotId robot);
  [[nodiscard]] Role choose(const RoleCue& cue) override;

 private:
  Role role_;
};

void describe(Heterogeneous::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
