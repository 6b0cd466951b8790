#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "idl/types/telemetry.h"
#include "robot_agent/brain/schemas/registry.h"

namespace tacit {

/// A weighted vector sum of motor schemas (the paper's behavioural assemblage).
class Assemblage {
 public:
  /// Holds the schemas whose gain in `ceiling` is not 0: the others can have no part in the sum.
  Assemblage(const SchemaConfigs& configs, const Self& self, const Gains& ceiling);

  /// The sum of all pushes, each times its gain. Call once per tick.
  [[nodiscard]] BodyVec sum(const Surroundings& around, const Gains& gains);

  /// The shares in the last sum.
  void report(std::vector<SchemaShare>& shares) const;

 private:
  struct Member {
    std::string_view name;
    std::size_t index = 0;  ///< Into the gains.
    std::unique_ptr<Schema> schema;
    double gain = 0.0;  ///< In the last sum, as is `push`.
    BodyVec push;
  };
  std::vector<Member> members_;
};

}  // namespace tacit
