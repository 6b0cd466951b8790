#include <benchmark/benchmark.h>

#include "idl/types/random.h"
#include "robot_agent/brain/brain.h"

namespace tacit {
namespace {

struct Scene {
  int teammates = 0;
  int enemies = 0;
  int obstacles = 0;
  double range_m = 75.0;
};

BodyVec somewhere(Stream& chance, double range_m) {
  return {chance.uniform(-range_m, range_m), chance.uniform(-range_m, range_m)};
}

Percept percept(const Scene& scene) {
  Stream chance(7, "scene");
  Percept percept;
  percept.sightings.push_back({Kind::Target, Colour::White, {10.0, 5.0}, 1.0});
  for (int i = 0; i < scene.teammates; ++i) {
    percept.sightings.push_back(
        {Kind::Teammate, Colour::Blue, somewhere(chance, scene.range_m), 0.2});
  }
  for (int i = 0; i < scene.enemies; ++i) {
    percept.sightings.push_back({Kind::Enemy, Colour::Red, somewhere(chance, scene.range_m), 0.2});
  }
  for (int i = 0; i < scene.obstacles; ++i) {
    percept.obstacles.push_back({somewhere(chance, 4.0), 1.0});
  }
  return percept;
}

void decide(benchmark::State& state, const BrainConfig& config, const Scene& scene) {
  Brain brain(config, RobotId{1}, 1);
  Percept seen = percept(scene);
  for (auto _ : state) {
    ++seen.tick;
    benchmark::DoNotOptimize(brain.decide(seen));
  }
}

BrainConfig crowd() {
  BrainConfig config;
  config.learner = "crowd";
  config.of<AvoidSoldiers>().reach_m = 5.0;
  return config;
}

void CrowdAmong31(benchmark::State& state) {
  decide(state, crowd(), {.teammates = 31, .obstacles = 2, .range_m = 20.0});
}
BENCHMARK(CrowdAmong31);

void LearningMomentumSixSoldiers(benchmark::State& state) {
  decide(state, {}, {.teammates = 5, .enemies = 20, .obstacles = 5});
}
BENCHMARK(LearningMomentumSixSoldiers);

void LearningMomentumByEnemies(benchmark::State& state) {
  decide(state, {}, {.teammates = 5, .enemies = static_cast<int>(state.range(0)), .obstacles = 2});
}
BENCHMARK(LearningMomentumByEnemies)->Arg(0)->Arg(5)->Arg(40)->Arg(120);

void LearningMomentumAmong100(benchmark::State& state) {
  decide(state, {}, {.teammates = 100, .enemies = 20, .obstacles = 2});
}
BENCHMARK(LearningMomentumAmong100);

}  // namespace
}  // namespace tacit
