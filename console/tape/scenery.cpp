#include "console/tape/scenery.h"

#include "idl/scenario/document.h"

namespace tacit {
namespace {

template <class Value>
bool take(Document& document, const std::string& section, std::string_view key, Value& into) {
  const auto found = document.find(section, key);
  const auto* const value = found ? std::get_if<Value>(&found->value) : nullptr;
  if (value != nullptr) into = *value;
  return value != nullptr;
}

std::optional<Scenery::Place> place_of(Document& document, const std::string& section) {
  Scenery::Place place;
  const bool there = take(document, section, "x_m", place.x_m) &&
                     take(document, section, "y_m", place.y_m) &&
                     take(document, section, "radius_m", place.radius_m);
  return there ? std::optional(place) : std::nullopt;
}

}  // namespace

Scenery scenery_of(std::string_view scenario_toml, const std::string& name) {
  Document document(scenario_toml, name);
  Scenery scenery;
  take(document, "physics", "tick_s", scenery.tick_s);
  take(document, "area", "width_m", scenery.width_m);
  take(document, "area", "height_m", scenery.height_m);
  take(document, "area", "border_walls", scenery.border_walls);
  take(document, "area", "walls", scenery.walls);
  take(document, "obstacles", "discs", scenery.discs);
  take(document, "robots", "radius_m", scenery.robot_radius_m);
  take(document, "operation", "map", scenery.map);
  scenery.focus = place_of(document, "target");
  if (!scenery.focus) scenery.focus = place_of(document, "base");
  return scenery;
}

}  // namespace tacit
