#pragma once

#include <memory>
#include <string>
#include <vector>

#include "idl/types/telemetry.h"
#include "robot_agent/brain/fsa/schema_use.h"

namespace tacit {

/// What comes out of a tick: a weighted sum of pushes, body frame, and an act. Empty by default.
struct Doing {
  BodyVec sum;
  Act act = Act::None;
};

/// A behavioural assemblage with fixed gains, and an act that goes with it.
class Activity {
 public:
  /// Leaves out schemas with gain 0. Throws ConfigError as `make_schema` does, and when there are
  /// more schemas than telemetry can show.
  Activity(const ActivityPlan& plan, const SchemaConfigs& configs, const Self& self);

  /// Call at most once per tick, ticks ascending.
  [[nodiscard]] Doing step(const Surroundings& around);

  /// The shares in the last step; none pushes when there was no step since `rest`.
  void report(std::vector<SchemaShare>& shares) const;
  void rest();

 private:
  struct Member {
    std::string name;
    double gain = 0.0;
    std::unique_ptr<Schema> schema;
    BodyVec push;  ///< In the last step.
  };
  std::vector<Member> members_;
  Act act_;
};

}  // namespace tacit
