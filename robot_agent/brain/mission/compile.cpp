#include "robot_agent/brain/mission/compile.h"

#include <algorithm>

#include "idl/cdl/parse.h"
#include "idl/cdl/resolve.h"
#include "idl/types/config_error.h"
#include "robot_agent/brain/mission/compiler.h"

namespace tacit {
namespace {

/// Throws when there is an error among `findings`, with all of them.
void stop_at_errors(cdl::Findings findings, std::string_view text, std::string_view name) {
  if (!cdl::has_error(findings)) return;
  cdl::locate(findings, text);
  std::string all;
  std::string last;
  for (const cdl::Finding& each : findings) {
    if (each.severity != cdl::Severity::Error) continue;
    std::string line = cdl::to_text(each, name);
    if (line == last) continue;  // Robots that share a part share its faults.
    all += (all.empty() ? "" : "\n") + line;
    last = std::move(line);
  }
  throw ConfigError(all);
}

}  // namespace

std::vector<RobotPlan> compile_mission(std::string_view text, std::string_view name) {
  const cdl::Parsed parsed = cdl::parse(text);
  stop_at_errors(parsed.findings, text, name);
  const cdl::Resolved resolved = cdl::resolve(parsed.mission);
  stop_at_errors(resolved.findings, text, name);
  if (resolved.robots.empty()) throw ConfigError(std::string(name) + ": it has no robots");
  MissionCompiler compiler;
  std::vector<RobotPlan> plans;
  for (std::size_t i = 0; i < resolved.robots.size(); ++i) {
    plans.push_back(compiler.robot(resolved.robots[i], {i, resolved.robots.size()}));
  }
  stop_at_errors(compiler.findings(), text, name);
  return plans;
}

}  // namespace tacit
