#include "robot_agent/brain/mission/compile.h"

#include "idl/cdl/parse.h"
#include "idl/cdl/resolve.h"
#include "idl/types/config_error.h"
#include "robot_agent/brain/mission/compiler.h"

namespace tacit {
std::vector<RobotPlan> compile_mission(std::string_view text, std::string_view name) {
  const cdl::Parsed parsed = cdl::parse(text);
  cdl::refuse_errors(parsed.findings, text, name);
  const cdl::Resolved resolved = cdl::resolve(parsed.mission);
  cdl::refuse_errors(resolved.findings, text, name);
  if (resolved.robots.empty()) throw ConfigError(std::string(name) + ": it has no robots");
  MissionCompiler compiler;
  std::vector<RobotPlan> plans;
  for (std::size_t i = 0; i < resolved.robots.size(); ++i) {
    plans.push_back(compiler.robot(resolved.robots[i], {i, resolved.robots.size()}));
  }
  cdl::refuse_errors(compiler.findings(), text, name);
  return plans;
}

}  // namespace tacit
