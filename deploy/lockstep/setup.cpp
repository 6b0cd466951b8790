#include "deploy/lockstep/setup.h"

namespace tacit {

void describe(Setup& setup, ParameterVisitor& visitor) {
  describe(setup.run, visitor);
  describe(setup.world, visitor);
  describe(setup.brain, visitor);
}

Setup read_setup(ScenarioFile& file) {
  Setup setup;
  file.fill(setup);
  file.refuse_unknown_sections();
  check(setup.world);
  check(setup.brain);
  return setup;
}

Tick last_tick(const Setup& setup) {
  return last_tick(setup.run.duration_s, setup.world.physics.tick_s);
}

}  // namespace tacit
