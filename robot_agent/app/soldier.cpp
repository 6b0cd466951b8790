#include "robot_agent/app/soldier.h"

#include "idl/scenario/digest.h"
#include "idl/scenario/run_config.h"
#include "idl/scenario/scenario_file.h"

namespace tacit {

Soldier read_soldier(const std::filesystem::path& file) {
  ScenarioFile scenario = ScenarioFile::read(file);
  Soldier soldier;
  RunConfig run;
  scenario.fill(run);
  soldier.brain = brain_defaults(mission_kind(run));
  scenario.fill(soldier.brain);
  if (soldier.brain.mission == MissionKind::Operation) scenario.fill(soldier.brain.script);
  check(soldier.brain);
  soldier.seed = static_cast<std::uint64_t>(run.seed);
  soldier.digest = scenario_digest(file);
  return soldier;
}

}  // namespace tacit
