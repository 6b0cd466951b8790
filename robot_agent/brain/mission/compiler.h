#pragma once

#include <string>
#include <string_view>

#include "idl/cdl/resolve.h"
#include "robot_agent/brain/mission/behaviours.h"
#include "robot_agent/brain/mission/compile.h"

namespace tacit {

/// Turns the resolved robots of a mission into plans, and collects what cannot be.
class MissionCompiler {
 public:
  [[nodiscard]] RobotPlan robot(const cdl::Robot& robot, const TeamPlace& place);
  [[nodiscard]] cdl::Findings& findings() { return findings_; }

 private:
  /// What `behaviour` does, without name and rules.
  StatePlan content(const cdl::Behaviour& behaviour, const cdl::Span& place);
  StatePlan automaton(const cdl::Behaviour& behaviour, const cdl::Span& place);
  StatePlan weighted_sum(const cdl::Behaviour& behaviour, const cdl::Span& place);
  StatePlan learner(const cdl::Behaviour& behaviour, const cdl::Span& place);
  Trigger trigger(const cdl::Behaviour& behaviour, const cdl::Span& place);
  Deed deed(const cdl::Behaviour& behaviour, const cdl::Span& place);
  Wheels wheels(const cdl::Device& device, const cdl::Span& place);
  void refuse(const char* rule, const std::string& what, const cdl::Span& place);

  TeamPlace place_;
  cdl::Findings findings_;
};

}  // namespace tacit
