#include "deploy/tacit/scene_json.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "deploy/lockstep/setup.h"
#include "idl/overlay/plan.h"
#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "idl/types/operation_script.h"
#include "world_server/world/terrain.h"

namespace tacit {
namespace {

using Json = nlohmann::ordered_json;

MapPlan plan_in(const std::string& overlay, const std::string& name) {
  const OverlayReading reading = read_overlay(overlay);
  refuse_errors(reading.findings, name);
  return plan_of(reading.map, Doors::Open);
}

Json at(const MapPoint& p) { return Json::array({p.x_m, p.y_m}); }

Json outline(const std::vector<MapPoint>& points) {
  Json list = Json::array();
  for (const MapPoint& p : points) list.push_back(at(p));
  return list;
}

Json place(const std::optional<MapPoint>& p) {
  return p ? Json{{"x", p->x_m}, {"y", p->y_m}} : Json();
}

Json bare_scene(const std::string& name) {
  Json scene{{"name", name}};
  for (const char* list : {"walls", "discs", "rooms", "doors", "halls", "points"}) {
    scene[list] = Json::array();
  }
  for (const char* nothing : {"start", "target", "base"}) scene[nothing] = nullptr;
  scene["shift"] = {{"x", 0.0}, {"y", 0.0}};
  return scene;
}

void add_names(Json& scene, const MapPlan& plan) {
  scene["shift"] = {{"x", plan.ground.shift_m.x_m}, {"y", plan.ground.shift_m.y_m}};
  for (const PlanRoom& room : plan.rooms) {
    scene["rooms"].push_back({{"name", room.name}, {"outline", outline(room.outline)}});
  }
  for (const PlanDoor& door : plan.doors) {
    scene["doors"].push_back({{"name", door.name}, {"from", at(door.from)}, {"to", at(door.to)}});
  }
  for (const MapHallway& hall : plan.halls) {
    scene["halls"].push_back(
        {{"name", hall.name}, {"centre", outline(hall.centre_line)}, {"width_m", hall.width_m}});
  }
  for (const PlanPoint& point : plan.points) {
    scene["points"].push_back(
        {{"name", point.name}, {"x", point.at.x_m}, {"y", point.at.y_m}, {"r", point.radius_m}});
  }
  scene["start"] = place(plan.ground.start);
}

void add_terrain(Json& scene, const Terrain& terrain) {
  scene["width_m"] = terrain.width_m;
  scene["height_m"] = terrain.height_m;
  for (const Wall& wall : terrain.walls) {
    scene["walls"].push_back({wall.from_m.x(), wall.from_m.y(), wall.to_m.x(), wall.to_m.y()});
  }
  for (const Disc& disc : terrain.obstacles) {
    scene["discs"].push_back({disc.centre_m.x(), disc.centre_m.y(), disc.radius_m});
  }
}

}  // namespace

std::string scene_of_map(const std::string& overlay, const std::string& name) {
  const MapPlan plan = plan_in(overlay, name);
  Json scene = bare_scene(name);
  scene["width_m"] = plan.ground.size.width_m;
  scene["height_m"] = plan.ground.size.height_m;
  for (const MapSegment& wall : plan.ground.walls) {
    scene["walls"].push_back({wall.from.x_m, wall.from.y_m, wall.to.x_m, wall.to.y_m});
  }
  scene["discs"] = plan.ground.discs;
  add_names(scene, plan);
  return scene.dump();
}

std::string scene_of_run(const RunDirectory& directory) {
  ScenarioFile file = ScenarioFile::read(directory.scenario_file());
  const Setup setup = read_setup(file);
  Json scene = bare_scene(directory.facts().scenario);
  add_terrain(scene, make_terrain(setup.world, seed(setup)));
  const WorldConfig& world = setup.world;
  switch (mission_kind(setup.run)) {
    case MissionKind::Guard:
      scene["target"] = {{"x", world.target.x_m}, {"y", world.target.y_m}};
      break;
    case MissionKind::Forage:
      scene["base"] = {{"x", world.forage.base.x_m},
                       {"y", world.forage.base.y_m},
                       {"r", world.forage.base.radius_m}};
      break;
    case MissionKind::Operation: {
      OperationScript script;
      ScenarioFile::read(directory.scenario_file()).fill(script);
      add_names(scene, plan_in(script.map, file.name()));
      break;
    }
  }
  return scene.dump();
}

}  // namespace tacit
