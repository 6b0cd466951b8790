#include "deploy/lockstep/setup.h"

#include "world_server/map/take_map.h"

namespace tacit {
namespace {

/// The mission decides which parameters there are and what they are by default.
void adopt_mission(Setup& setup) {
  const MissionKind mission = mission_kind(setup.run);
  if (setup.world.mission != mission) {
    const Setup defaults = setup_for(mission);
    setup.world = defaults.world;
    setup.brain = defaults.brain;
  }
}

}  // namespace

Setup setup_for(MissionKind mission) {
  Setup setup{{}, world_defaults(mission), brain_defaults(mission)};
  setup.run.mission = name(mission);
  return setup;
}

void describe(Setup& setup, ParameterVisitor& visitor) {
  describe(setup.run, visitor);
  adopt_mission(setup);
  describe(setup.world, visitor);
  describe(setup.brain, visitor);
}

Setup read_setup(ScenarioFile& file) {
  Setup setup;
  file.fill(setup);
  file.refuse_unknown_sections();
  take_map(setup.world, file);
  setup.brain.script = setup.world.operation.script;
  check(setup.world);
  check(setup.brain);
  return setup;
}

Tick last_tick(const Setup& setup) {
  return last_tick(setup.run.duration_s, setup.world.physics.tick_s);
}

std::int64_t strategy(const Setup& setup) {
  return setup.world.mission == MissionKind::Guard ? setup.world.enemies.strategy : 0;
}

}  // namespace tacit
