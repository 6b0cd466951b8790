#pragma once

#include <cstdint>
#include <vector>

#include "idl/types/config_error.h"
#include "idl/types/random.h"
#include "world_server/world/world.h"

namespace tacit {

/// An area of 100 m by 100 m with nothing in it but `robots` robots round a target in the middle.
inline WorldConfig empty_world(std::int64_t robots) {
  WorldConfig config;
  config.area.width_m = 100.0;
  config.area.height_m = 100.0;
  config.target.x_m = 50.0;
  config.target.y_m = 50.0;
  config.obstacles.coverage_percent = 0.0;
  config.robots.count = robots;
  config.enemies.strategy = 0;
  return config;
}

/// A small area full of obstacles and enemies, so that much happens in few ticks.
inline WorldConfig busy_world(std::int64_t robots) {
  WorldConfig config = empty_world(robots);
  config.area.width_m = 60.0;
  config.area.height_m = 60.0;
  config.target.x_m = 30.0;
  config.target.y_m = 30.0;
  config.obstacles.coverage_percent = 8.0;
  config.obstacles.max_radius_m = 2.0;
  config.robots.ring_radius_m = 5.0;
  config.obstacles.keep_free_m = 8.0;
  config.enemies.strategy = 4;
  config.enemies.period_scale = 0.2;
  return config;
}

/// Commands that mean nothing but use the whole range of what a robot can want.
inline std::vector<Command> random_commands(std::int64_t robots, Tick tick, Stream& chance) {
  std::vector<Command> commands;
  for (std::int64_t i = 1; i <= robots; ++i) {
    commands.push_back({RobotId{static_cast<std::uint16_t>(i)},
                        tick,
                        {chance.uniform(-2.0, 2.0), chance.uniform(-2.0, 2.0)},
                        chance.uniform(-1.0, 1.0)});
  }
  return commands;
}

/// What the world refuses `config` with; empty when it does not.
inline std::string refusal(const WorldConfig& config) {
  try {
    const World world(config, 1);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return {};
}

}  // namespace tacit
