#include "deploy/lockstep/operation_setup.h"

#include "world_server/map/take_map.h"

namespace tacit {

Setup operation_setup(const OperationWish& wish) {
  Setup setup = setup_for(MissionKind::Operation);
  setup.run.duration_s = kOperation_s;
  OperationScript& script = setup.world.operation.script;
  script = compose_operation(wish);
  setup.world.robots.count = static_cast<std::int64_t>(script.starts.size());
  ScenarioFile nothing = ScenarioFile::parse("", wish.map.name);
  take_map(setup.world, nothing);
  setup.brain.script = script;
  check(setup.world);
  check(setup.brain);
  return setup;
}

}  // namespace tacit
