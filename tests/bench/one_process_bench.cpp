// Whole-team speed in one process, in four parts, each a ratio or a rate taken in this run:
//   guard   ticks/s of the guard scenario (6 LM soldiers) over those of bare Bullet: the same
//   bodies
//           on the same paths through stepSimulation, nothing else;
//   crowd   robot-steps/s of the crowd scenario at growing team sizes, in the same area, where a
//           robot sees ever more of the others, and in an area that grows with the team;
//   forage  ticks/s of a forage mission with 12 Q-learning robots and 30 mines, runs in a row;
//   memory  resident memory while a small guard run goes on for very many ticks.
// Samples of the two sides of a ratio take turns; medians are printed. Times are CPU times of the
// one thread.
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "deploy/lockstep/setup.h"
#include "deploy/lockstep/team.h"
#include "world_server/world/physics.h"
#include "world_server/world/terrain.h"

namespace tacit {
namespace {

constexpr int kSamples = 7;

/// CPU time of this thread: on a machine shared with others it says more than the wall clock.
double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Setup scenario(const std::string& name,
               const std::vector<std::pair<std::string, std::string>>& set) {
  ScenarioFile file =
      ScenarioFile::read(std::string(TACIT_SOURCE_DIR) + "/deploy/scenarios/" + name + ".toml");
  for (const auto& [path, value] : set) {
    file.set(path, value);
  }
  return read_setup(file);
}

/// What moved in a run, tick by tick: enough to move the same bodies along the same paths again.
struct Film {
  struct Shot {
    std::vector<std::pair<std::size_t, WorldVec>> appear;      ///< Body, place.
    std::vector<std::pair<std::size_t, WorldVec>> velocities;  ///< Body, m/s in this tick.
    std::vector<std::size_t> vanish;
  };
  std::vector<Shot> shots;
  std::size_t bodies = 0;
  double mean_bodies = 0.0;
};

/// Places by body: robots first, then enemies by number.
std::map<std::size_t, WorldVec> places(const World& world, std::size_t robots, WorldView& view) {
  world.view(view);
  std::map<std::size_t, WorldVec> all;
  for (const ViewedRobot& robot : view.robots) {
    all.emplace(robot.robot.value - 1U, robot.pose.position_m);
  }
  for (const ViewedEnemy& enemy : view.enemies) {
    all.emplace(robots + enemy.enemy.value, enemy.position_m);
  }
  return all;
}

Film film(const Setup& setup, int ticks) {
  Team team(setup.world, setup.brain, seed(setup));
  const auto robots = static_cast<std::size_t>(setup.world.robots.count);
  WorldView view;
  Film film;
  std::map<std::size_t, WorldVec> before;
  std::map<std::size_t, WorldVec> now = places(team.world(), robots, view);
  for (int i = 0; i < ticks; ++i) {
    team.step();
    const std::map<std::size_t, WorldVec> next = places(team.world(), robots, view);
    Film::Shot shot;
    for (const auto& [body, place] : now) {
      const auto there = next.find(body);
      if (!before.contains(body)) {
        shot.appear.emplace_back(body, place);
      }
      if (there == next.end()) {
        shot.vanish.push_back(body);
      } else {
        shot.velocities.emplace_back(body,
                                     (1.0 / setup.world.physics.tick_s) * (there->second - place));
      }
      film.bodies = std::max(film.bodies, body + 1);
    }
    film.mean_bodies += static_cast<double>(now.size()) / ticks;
    film.shots.push_back(std::move(shot));
    before = std::move(now);
    now = next;
  }
  return film;
}

enum class Step { Do, Leave };

/// CPU seconds for moving the filmed bodies along their paths, with or without Bullet's step.
double replay_s(const Setup& setup, const Film& film, Step step) {
  Physics physics(make_terrain(setup.world, seed(setup)), Physics::Care::All);
  std::vector<BodySlot> slots(film.bodies);
  const double start = cpu_s();
  for (const Film::Shot& shot : film.shots) {
    for (const auto& [body, place] : shot.appear) {
      slots[body] = physics.add(place, setup.world.robots.radius_m);
    }
    for (const auto& [body, velocity] : shot.velocities) {
      physics.set_velocity(slots[body], velocity);
    }
    if (step == Step::Do) {
      physics.step(setup.world.physics.tick_s);
    }
    for (const std::size_t body : shot.vanish) {
      physics.remove(slots[body]);
    }
  }
  return cpu_s() - start;
}

double team_s(const Setup& setup, int ticks) {
  Team team(setup.world, setup.brain, seed(setup));
  const double start = cpu_s();
  for (int i = 0; i < ticks; ++i) {
    team.step();
  }
  return cpu_s() - start;
}

void guard() {
  constexpr int kTicks = 9000;
  const Setup setup = scenario("guard", {{"sight.blocked_by_obstacles", "true"}});
  const Film guard_film = film(setup, kTicks);
  std::vector<double> rate;
  std::vector<double> ratio;
  for (int i = 0; i < kSamples; ++i) {
    const double bare_s =
        replay_s(setup, guard_film, Step::Do) - replay_s(setup, guard_film, Step::Leave);
    const double whole_s = team_s(setup, kTicks);
    rate.push_back(kTicks / whole_s);
    ratio.push_back(bare_s / whole_s);
  }
  std::printf("guard    6 robots, %.1f moving bodies on average\n", guard_film.mean_bodies);
  std::printf("         %.0f ticks/s, %.0f robot-steps/s, %.0f x real time\n", median(rate),
              6.0 * median(rate), setup.world.physics.tick_s * median(rate));
  std::printf("         %.3f of bare Bullet (median of %d, %.3f to %.3f)\n\n", median(ratio),
              kSamples, *std::min_element(ratio.begin(), ratio.end()),
              *std::max_element(ratio.begin(), ratio.end()));
}

enum class Area { Same, GrowsWithTheTeam };

Setup crowd_of(int robots, Area area) {
  constexpr double kRobotsOfTheScenario = 100.0;
  const Setup given = scenario("crowd", {{"robots.count", std::to_string(robots)}});
  if (area == Area::Same) {
    return given;
  }
  const double scale = std::sqrt(robots / kRobotsOfTheScenario);
  Setup scaled = given;
  scaled.world.area.width_m *= scale;
  scaled.world.area.height_m *= scale;
  scaled.world.target.x_m *= scale;
  scaled.world.target.y_m *= scale;
  scaled.world.obstacles.keep_free_m = std::min(given.world.obstacles.keep_free_m, 5.0 * scale);
  return scaled;
}

void crowd(const std::vector<int>& sizes, Area area) {
  std::printf("crowd    %s\n",
              area == Area::Same ? "in the same area" : "as many per square metre");
  std::printf("         robots      ticks/s   robot-steps/s   us per robot and tick   sighted\n");
  std::map<int, std::vector<double>> rates;
  std::map<int, double> sighted;
  for (int sample = 0; sample < 5; ++sample) {
    for (const int robots : sizes) {
      const Setup setup = crowd_of(robots, area);
      Team team(setup.world, setup.brain, seed(setup) + static_cast<std::uint64_t>(sample));
      const int ticks = std::max(100, 120000 / robots);
      team.step();
      const double start = cpu_s();
      for (int i = 0; i < ticks; ++i) {
        team.step();
      }
      rates[robots].push_back(ticks / (cpu_s() - start));
      double seen = 0.0;
      for (const Percept& percept : team.world().percepts()) {
        seen += static_cast<double>(percept.sightings.size());
      }
      sighted[robots] += seen / robots / 5.0;
    }
  }
  for (const int robots : sizes) {
    const double rate = median(rates[robots]);
    std::printf("         %6d %12.0f %15.0f %23.2f %9.1f\n", robots, rate, robots * rate,
                1e6 / (robots * rate), sighted[robots]);
  }
  std::printf("\n");
}

/// CPU seconds for `runs` whole forage runs, and the ticks that they took.
std::pair<double, Tick> foraging(Setup setup, int runs) {
  Tick ticks = 0;
  double spent_s = 0.0;
  for (int run = 0; run < runs; ++run) {
    Team team(setup.world, setup.brain, seed(setup));
    const double start = cpu_s();
    while (!team.done(last_tick(setup))) {
      team.step();
    }
    spent_s += cpu_s() - start;
    ticks += team.tick();
    ++setup.run.seed;
  }
  return {spent_s, ticks};
}

void forage() {
  constexpr int kRuns = 10;
  std::vector<double> rates;
  for (int i = 0; i < kSamples; ++i) {
    const auto [spent_s, ticks] =
        foraging(scenario("forage", {{"robots.count", "12"}, {"mines.count", "30"}}), kRuns);
    rates.push_back(static_cast<double>(ticks) / spent_s);
  }
  std::printf("forage   12 robots, 30 mines: %.0f ticks/s (median of %d, %.0f to %.0f)\n\n",
              median(rates), kSamples, *std::min_element(rates.begin(), rates.end()),
              *std::max_element(rates.begin(), rates.end()));
}

double resident_mib() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0.0;
  statm >> pages >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

void memory(long ticks) {
  const Setup setup = scenario("guard", {{"robots.count", "2"}});
  Team team(setup.world, setup.brain, seed(setup));
  std::printf("memory   million ticks   resident MiB\n");
  for (long i = 0; i <= ticks; ++i) {
    if (i % (ticks / 10) == 0) {
      std::printf("         %13.1f %14.1f\n", static_cast<double>(i) / 1e6, resident_mib());
      std::fflush(stdout);
    }
    team.step();
  }
}

/// The numbers in the arguments from the third on, or `otherwise`.
std::vector<int> numbers(int argc, char** argv, std::vector<int> otherwise) {
  std::vector<int> given;
  for (int i = 2; i < argc; ++i) {
    given.push_back(std::max(1, std::atoi(argv[i])));
  }
  return given.empty() ? std::move(otherwise) : given;
}

}  // namespace
}  // namespace tacit

int main(int argc, char** argv) {
  const std::string part = argc > 1 ? argv[1] : "all";
  if (part == "--help" || (part != "all" && part != "guard" && part != "crowd" &&
                           part != "forage" && part != "memory")) {
    std::printf(
        "usage: one_process_bench [all | guard | crowd [ROBOTS...] | forage | memory [TICKS]]\n");
    return part == "--help" ? 0 : 2;
  }
  if (part == "all" || part == "guard") {
    tacit::guard();
  }
  if (part == "all" || part == "crowd") {
    const std::vector<int> sizes =
        tacit::numbers(part == "crowd" ? argc : 0, argv, {6, 12, 25, 50, 100, 250, 500, 1000});
    tacit::crowd(sizes, tacit::Area::Same);
    tacit::crowd(sizes, tacit::Area::GrowsWithTheTeam);
  }
  if (part == "all" || part == "forage") {
    tacit::forage();
  }
  if (part == "all" || part == "memory") {
    tacit::memory(argc > 2 ? std::max(10L, std::atol(argv[2])) : 10'000'000L);
  }
  return 0;
}
