#pragma once

#include <algorithm>
#include <vector>

#include "tests/world/sample_worlds.h"

namespace tacit {

/// An area of 40 m by 40 m with the base in the middle, `robots` robots 2 m from it (robot 1 in the
/// east), one mine in a corner, and neither mud nor hunters.
inline WorldConfig bare_field(std::int64_t robots) {
  WorldConfig config = world_defaults(MissionKind::Forage);
  config.area.width_m = 40.0;
  config.area.height_m = 40.0;
  config.robots.count = robots;
  config.forage.base = {20.0, 20.0, 0.5};
  config.forage.mines.count = 0;
  config.forage.mines.places = {{3.0, 3.0}};
  config.forage.mud.per_tick = 0.0;
  config.forage.hunters.count = 0;
  return config;
}

/// Everything at once in a small field.
inline WorldConfig wild_field(std::int64_t robots) {
  WorldConfig config = bare_field(robots);
  config.area.width_m = 20.0;
  config.area.height_m = 20.0;
  config.area.walls = {{14.0, 4.0, 14.0, 9.0}};
  config.obstacles.coverage_percent = 5.0;
  config.obstacles.max_radius_m = 1.0;
  config.forage.base = {10.0, 10.0, 0.5};
  config.forage.mines.count = 5;
  config.forage.mines.keep_from_base_m = 1.0;
  config.forage.reach.pick_up_m = 1.0;
  config.forage.reach.drop_m = 4.0;
  config.forage.reach.aid_m = 2.0;
  config.forage.mud.per_tick = 0.002;
  config.forage.hunters.count = 2;
  config.forage.hunters.min_wait_ticks = 0;
  config.forage.hunters.max_wait_ticks = 60;
  return config;
}

inline Command acting(std::uint16_t robot, Act act, const BodyVec& velocity_mps = {}) {
  return {RobotId{robot}, 0, velocity_mps, 0.0, act};
}

/// Commands that use the whole range of what a forager can want.
inline std::vector<Command> random_deeds(std::int64_t robots, Stream& chance) {
  std::vector<Command> commands;
  for (std::uint16_t i = 1; i <= robots; ++i) {
    commands.push_back({RobotId{i},
                        0,
                        {chance.uniform(-0.2, 0.6), chance.uniform(-0.3, 0.3)},
                        chance.uniform(-1.0, 1.0),
                        static_cast<Act>(chance.below(5))});
  }
  return commands;
}

/// A world of which every step's events and view are kept; the event that begins the run stands
/// apart.
struct Field {
  explicit Field(const WorldConfig& config, std::uint64_t seed = 1) : world(config, seed) {
    world.view(view);
  }

  void step(const std::vector<Command>& commands = {}) {
    before = view;
    const auto events = world.step(commands);
    told.clear();
    for (const Event& event : events) {
      if (const auto* beginning = std::get_if<ForageBegun>(&event.what)) {
        begun.push_back(*beginning);
      } else {
        told.push_back(event);
      }
    }
    world.view(view);
  }

  /// The last step's events of one kind.
  template <class What>
  [[nodiscard]] std::vector<What> all() const {
    std::vector<What> found;
    for (const Event& event : told) {
      if (const auto* what = std::get_if<What>(&event.what)) {
        found.push_back(*what);
      }
    }
    return found;
  }
  [[nodiscard]] const Percept& percept(std::size_t robot) const {
    return world.percepts()[robot - 1];
  }
  [[nodiscard]] WorldVec place(std::size_t robot) const {
    return view.robots[robot - 1].pose.position_m;
  }

  std::vector<ForageBegun> begun;
  World world;
  WorldView view;
  WorldView before;
  std::vector<Event> told;
};

/// How many sightings of one kind and colour `percept` holds.
inline std::ptrdiff_t seen(const Percept& percept, Kind kind, Colour colour) {
  return std::count_if(percept.sightings.begin(), percept.sightings.end(),
                       [&](const Sighting& s) { return s.kind == kind && s.colour == colour; });
}

}  // namespace tacit
