#include "deploy/lockstep/setup.h"

#include <algorithm>
#include <cmath>

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
  return static_cast<Tick>(
      std::max(1.0, std::floor(setup.run.duration_s / setup.world.physics.tick_s + 0.5)));
}

}  // namespace tacit
