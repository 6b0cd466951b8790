#include "world_server/app/mission.h"

#include "idl/scenario/digest.h"
#include "idl/scenario/run_config.h"
#include "idl/scenario/scenario_file.h"
#include "world_server/map/take_map.h"

namespace tacit {

Mission read_mission(const std::filesystem::path& file, std::optional<double> duration_s) {
  ScenarioFile scenario = ScenarioFile::read(file);
  Mission mission;
  RunConfig run;
  scenario.fill(run);
  mission.world = world_defaults(mission_kind(run));
  scenario.fill(mission.world);
  take_map(mission.world, scenario);
  check(mission.world);
  mission.seed = static_cast<std::uint64_t>(run.seed);
  mission.last_tick = last_tick(duration_s.value_or(run.duration_s), mission.world.physics.tick_s);
  mission.digest = scenario_digest(file);
  return mission;
}

}  // namespace tacit
