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

Percept forage_percept(std::initializer_list<Kind> others) {
  Percept percept;
  Stream chance(7, "forage scene");
  const auto see = [&](Kind kind, Colour colour) {
    percept.sightings.push_back({kind, colour, somewhere(chance, 20.0), 0.2});
  };
  for (int i = 0; i < 30; ++i) see(Kind::Mine, Colour::Orange);
  for (int i = 0; i < 11; ++i) see(Kind::Teammate, Colour::Blue);
  see(Kind::Base, Colour::Purple);
  for (const Kind kind : others) see(kind, Colour::Red);
  for (int i = 0; i < 2; ++i) percept.obstacles.push_back({somewhere(chance, 4.0), 1.0});
  return percept;
}

void forage(benchmark::State& state, const char* learner, std::initializer_list<Kind> others) {
  BrainConfig config = brain_defaults(MissionKind::Forage);
  config.learner = learner;
  Brain brain(config, RobotId{1}, 1);
  Percept seen = forage_percept(others);
  for (auto _ : state) {
    ++seen.tick;
    benchmark::DoNotOptimize(brain.decide(seen));
  }
}

void ForagerAmong30Mines(benchmark::State& state) { forage(state, "homogeneous", {}); }
BENCHMARK(ForagerAmong30Mines);

void SoldierAmong30Mines(benchmark::State& state) { forage(state, "homogeneous", {Kind::Enemy}); }
BENCHMARK(SoldierAmong30Mines);

void QLearnerAmong30Mines(benchmark::State& state) { forage(state, "q", {}); }
BENCHMARK(QLearnerAmong30Mines);

}  // namespace
}  // namespace tacit
