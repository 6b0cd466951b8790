#include "world_server/map/take_map.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "idl/overlay/check.h"
#include "idl/overlay/ground.h"
#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "world_server/world/missions/operation_map.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostWalls = 60'000;
constexpr const char* kKey = "area.map";

fs::path file_of(const std::string& map, const ScenarioFile& scenario) {
  const bool beside = scenario.given(kKey) == Given::File;
  return beside ? fs::path(scenario.name()).parent_path() / map : fs::path(map);
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!fs::is_regular_file(file) || !in) {
    throw ConfigError("[area] map: " + file.string() +
                      ": cannot be read, wanted a map (MissionLab overlay, .ovl)");
  }
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

OverlayMap read_map(std::string_view text, const fs::path& file) {
  OverlayReading reading = read_overlay(text);
  refuse_errors(reading.findings, file.string());
  refuse_errors(check(reading.map), file.string());
  return std::move(reading.map);
}

bool fits(double size_m) { return size_m >= 1.0 && size_m <= 1e5; }

void require_fit(const MapGround& ground, const fs::path& file) {
  if (!fits(ground.size.width_m) || !fits(ground.size.height_m)) {
    throw ConfigError(file.string() + ": found an area of " + std::to_string(ground.size.width_m) +
                      " m by " + std::to_string(ground.size.height_m) +
                      " m, wanted 1 to 100000 m each way");
  }
  if (ground.walls.size() > kMostWalls || ground.discs.size() > kMostWalls) {
    throw ConfigError(file.string() + ": found " + std::to_string(ground.walls.size()) +
                      " walls and " + std::to_string(ground.discs.size()) +
                      " obstacles, wanted at most " + std::to_string(kMostWalls) + " of each");
  }
}

/// Puts what a map says where nobody with more to say has spoken.
class Taker {
 public:
  Taker(WorldConfig& world, const ScenarioFile& scenario) : world_(world), scenario_(scenario) {}

  void take(const MapGround& ground) {
    put("area.width_m", world_.area.width_m, ground.size.width_m);
    put("area.height_m", world_.area.height_m, ground.size.height_m);
    put("obstacles.coverage_percent", world_.obstacles.coverage_percent, 0.0);
    put("robots.start", world_.robots.start, std::string("gathered"));
    for (const MapSegment& wall : ground.walls) {
      world_.area.walls.push_back({wall.from.x_m, wall.from.y_m, wall.to.x_m, wall.to.y_m});
    }
    world_.obstacles.discs.insert(world_.obstacles.discs.end(), ground.discs.begin(),
                                  ground.discs.end());
    take_focus(ground);
    take_mines(ground);
  }

 private:
  template <class Value>
  void put(const char* path, Value& value, const Value& from_map) const {
    if (free(path)) value = from_map;
  }

  [[nodiscard]] bool free(const char* path) const {
    const Given given = scenario_.given(path);
    return given == Given::Nobody || given < scenario_.given(kKey);
  }

  void take_focus(const MapGround& ground) const {
    const MapPoint middle{ground.size.width_m / 2.0, ground.size.height_m / 2.0};
    const MapPoint at = ground.start.value_or(middle);
    if (world_.mission == MissionKind::Guard) {
      put("target.x_m", world_.target.x_m, at.x_m);
      put("target.y_m", world_.target.y_m, at.y_m);
    } else {
      put("base.x_m", world_.forage.base.x_m, at.x_m);
      put("base.y_m", world_.forage.base.y_m, at.y_m);
    }
  }

  void take_mines(const MapGround& ground) const {
    if (ground.mines.empty() || world_.mission != MissionKind::Forage) return;
    put("mines.places", world_.forage.mines.places, ground.mines);
    put("mines.count", world_.forage.mines.count, std::int64_t{0});
  }

  WorldConfig& world_;
  const ScenarioFile& scenario_;
};

/// The map alone says how large an operation's area is; who named the map knows nothing better.
void refuse_other_size(const char* key, double wanted_m, double map_m, bool free) {
  if (!free && wanted_m != map_m) {
    throw ConfigError(std::string("[area] ") + key + ": found " + std::to_string(wanted_m) +
                      ", wanted " + std::to_string(map_m) +
                      " m as the operation's map says, or nothing");
  }
}

void take_operation_map(WorldConfig& world, const ScenarioFile& file) {
  std::string& text = world.operation.script.map;
  const Given map_given = std::max(file.given(kKey), file.given("operation.map"));
  const auto free = [&](const char* path) {
    return file.given(path) == Given::Nobody || file.given(path) < map_given;
  };
  if (!world.area.map.empty()) {
    const fs::path path = file_of(world.area.map, file);
    text = text_of(path);
    // For errors that name the file.
    (void)read_map(text, path);
    world.area.map.clear();
  }
  if (text.empty()) return;
  const MapPlan plan = operation_plan(world);
  const MapSize& size = plan.ground.size;
  refuse_other_size("width_m", world.area.width_m, size.width_m, free("area.width_m"));
  refuse_other_size("height_m", world.area.height_m, size.height_m, free("area.height_m"));
  take_ground(plan, world);
}

}  // namespace

void take_map(WorldConfig& world, const ScenarioFile& file) {
  if (world.mission == MissionKind::Operation) return take_operation_map(world, file);
  if (world.area.map.empty()) return;
  const fs::path path = file_of(world.area.map, file);
  const OverlayMap map = read_map(text_of(path), path);
  const Doors doors = world.area.doors == "closed" ? Doors::Closed : Doors::Open;
  const MapGround ground = ground_of(map, doors);
  require_fit(ground, path);
  Taker(world, file).take(ground);
  world.area.map.clear();
}

}  // namespace tacit
