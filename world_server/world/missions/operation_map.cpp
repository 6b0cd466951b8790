#include "world_server/world/missions/operation_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "idl/overlay/check.h"
#include "idl/overlay/reader.h"
#include "idl/overlay/tokens.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kFile = "[operation] map";
constexpr std::size_t kMostWalls = 60'000;

/// MissionLab's names, and our own for what has been tested.
constexpr std::array<std::pair<std::string_view, Colour>, 15> kColours{{
    {"WHITE", Colour::White},
    {"BLUE", Colour::Blue},
    {"RED", Colour::Red},
    {"YELLOW", Colour::Yellow},
    {"ORANGE", Colour::Orange},
    {"PURPLE", Colour::Purple},
    {"GREEN", Colour::Green},
    {"BLACK", Colour::Black},
    {"DARKSEAGREEN", Colour::SeaGreen},
    {"SEAGREEN", Colour::SeaGreen},
    {"BROWN", Colour::Brown},
    {"LIGHTBLUE", Colour::LightBlue},
    {"LIGHT BLUE", Colour::LightBlue},
    {"GREY", Colour::Grey},
    {"GRAY", Colour::Grey},
}};

MapFindings odd_colours(const OverlayMap& map) {
  MapFindings findings;
  for (const MapStatement& statement : map.statements) {
    const auto* object = std::get_if<MapObject>(&statement.content);
    if (object != nullptr && findings.size() < kMostFindings && !map_colour(object->colour)) {
      findings.push_back({Severity::Error, statement.at,
                          "found an object of colour \"" + object->colour +
                              "\", wanted white, blue, red, yellow, orange, purple, green, black, "
                              "DarkSeaGreen, brown, lightblue or grey"});
    }
  }
  return findings;
}

void require_few(std::size_t count, std::size_t most, const std::string& what) {
  if (count > most) {
    throw ConfigError(std::string(kFile) + ": found " + std::to_string(count) + " " + what +
                      ", wanted at most " + std::to_string(most));
  }
}

void check_size(const MapPlan& plan) {
  const MapSize& size = plan.ground.size;
  const auto fits = [](double size_m) { return size_m >= 1.0 && size_m <= 1e5; };
  if (!fits(size.width_m) || !fits(size.height_m)) {
    throw ConfigError(std::string(kFile) + ": found an area of " + std::to_string(size.width_m) +
                      " m by " + std::to_string(size.height_m) +
                      " m, wanted 1 to 100000 m each way");
  }
  require_few(plan.ground.walls.size(), kMostWalls, "walls");
  require_few(plan.ground.discs.size(), kMostWalls, "obstacles");
  require_few(plan.rooms.size(), kMostMapThings, "rooms");
  require_few(plan.halls.size(), kMostMapThings, "hallways");
  require_few(plan.doors.size(), kMostMapThings, "doors");
  require_few(plan.gaps.size(), kMostMapThings, "gaps");
  require_few(plan.objects.size(), kMostMapThings, "objects");
  require_few(plan.points.size(), kMostMapThings, "points");
}

/// What is larger than any percept tells would make percepts that nobody takes.
constexpr double kFarthestM = 2e5;
constexpr double kWidestM = 1e4;

void require(bool sound, const std::string& what) {
  if (!sound) {
    throw ConfigError(std::string(kFile) + ": found " + what + ", wanted places within " +
                      std::to_string(static_cast<int>(kFarthestM)) +
                      " m of the area's corner, and nothing wider than " +
                      std::to_string(static_cast<int>(kWidestM)) + " m");
  }
}

bool near(const MapPoint& p) {
  return std::abs(p.x_m) <= kFarthestM && std::abs(p.y_m) <= kFarthestM;
}

void check_hallway(const MapHallway& hall) {
  double length_m = 0.0;
  for (std::size_t i = 0; i < hall.centre_line.size(); ++i) {
    require(near(hall.centre_line[i]), "hallway \"" + hall.name + "\" far away");
    if (i > 0) {
      length_m += (place_of(hall.centre_line[i]) - place_of(hall.centre_line[i - 1])).norm();
    }
  }
  require(length_m <= kFarthestM && hall.width_m <= kWidestM,
          "hallway \"" + hall.name + "\" longer or wider than that");
}

void check_measures(const MapPlan& plan) {
  std::for_each(plan.halls.begin(), plan.halls.end(), check_hallway);
  for (const auto* openings : {&plan.doors, &plan.gaps}) {
    for (const PlanDoor& door : *openings) {
      require(near(door.from) && near(door.to), "door or gap \"" + door.name + "\" far away");
    }
  }
  for (const MapObject& object : plan.objects) {
    require(near(object.centre) && object.radius_m <= kWidestM,
            "an object of colour \"" + object.colour + "\" far away or wider than that");
  }
}

/// Rows of `more` that `rows` does not hold go to its end.
void add_missing(const std::vector<std::vector<double>>& more,
                 std::vector<std::vector<double>>& rows) {
  std::set<std::vector<double>> known(rows.begin(), rows.end());
  for (const auto& row : more) {
    if (known.insert(row).second) {
      rows.push_back(row);
    }
  }
}

}  // namespace

std::optional<Colour> map_colour(std::string_view name) {
  const std::string wanted = capitals(name);
  const auto* const found = std::find_if(kColours.begin(), kColours.end(),
                                         [&](const auto& each) { return each.first == wanted; });
  return found == kColours.end() ? std::nullopt : std::optional(found->second);
}

MapPlan operation_plan(const WorldConfig& config) {
  const std::string& text = config.operation.script.map;
  if (config.mission != MissionKind::Operation || text.empty()) {
    return {};
  }
  const OverlayReading reading = read_overlay(text);
  refuse_errors(reading.findings, kFile);
  refuse_errors(check(reading.map), kFile);
  refuse_errors(odd_colours(reading.map), kFile);
  MapPlan plan = plan_of(reading.map, config.area.doors == "closed" ? Doors::Closed : Doors::Open);
  check_size(plan);
  check_measures(plan);
  return plan;
}

void take_ground(const MapPlan& plan, WorldConfig& config) {
  if (config.mission != MissionKind::Operation || config.operation.script.map.empty()) {
    return;
  }
  const MapGround& ground = plan.ground;
  config.area.width_m = ground.size.width_m;
  config.area.height_m = ground.size.height_m;
  config.operation.shift_x_m = ground.shift_m.x_m;
  config.operation.shift_y_m = ground.shift_m.y_m;
  std::vector<std::vector<double>> walls;
  for (const MapSegment& wall : ground.walls) {
    walls.push_back({wall.from.x_m, wall.from.y_m, wall.to.x_m, wall.to.y_m});
  }
  add_missing(walls, config.area.walls);
  add_missing(ground.discs, config.obstacles.discs);
}

}  // namespace tacit
