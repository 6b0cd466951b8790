#include "robot_agent/brain/mission/primitives.h"

#include "robot_agent/brain/mission/parts.h"

namespace tacit {
namespace {

using cdl::Use;

/// A parameter under one of the names that MissionLab's versions give it; null when it is not there
/// or only refers to something around that is not there.
const cdl::Value* parameter(const cdl::Behaviour& behaviour, std::string_view name) {
  for (const cdl::Parameter& each : behaviour.parameters) {
    if (each.name == name && !std::holds_alternative<cdl::FromAbove>(each.value)) {
      return &each.value;
    }
  }
  return nullptr;
}

std::optional<double> number(const cdl::Behaviour& behaviour, std::string_view name) {
  const cdl::Value* value = parameter(behaviour, name);
  const double* number = value == nullptr ? nullptr : std::get_if<double>(value);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

ThingSet classes(const cdl::Behaviour& behaviour, cdl::Findings& findings, const cdl::Span& place) {
  const Arguments given(behaviour, Use::Behaviour, place, findings);
  for (const std::string_view name : {"classes", "Objects"}) {
    if (given.has(name)) return given.things(name);
  }
  given.refuse("lacks the parameter %classes");
  return Thing::Mine;
}

SchemaUse bare(std::string_view schema, double gain, ThingSet things = {}) {
  return {std::string(schema), gain, things, {}};
}

SchemaUse noise(const cdl::Behaviour& behaviour, double gain) {
  const auto persistence = number(behaviour, "persistence");
  if (!persistence || *persistence < 1.0) return bare(Noise::kName, gain);
  return use_of<Noise>(gain, {static_cast<std::int64_t>(*persistence)});
}

SchemaUse avoid_obstacles(const cdl::Behaviour& behaviour, double gain) {
  const auto sphere_m = number(behaviour, "sphere");
  const auto margin_m = number(behaviour, "safety_margin");
  if (!sphere_m || !margin_m) return bare(AvoidObstacles::kName, gain);
  return use_of<AvoidObstacles>(gain, {*sphere_m, *margin_m});
}

}  // namespace

std::optional<SchemaUse> schema_called(const cdl::Behaviour& behaviour, double gain,
                                       cdl::Findings& findings, const cdl::Span& place) {
  const std::string& word = behaviour.name;
  if (word == "NOISE" || word == "WANDER") return noise(behaviour, gain);
  if (word == "AVOID_OBSTACLES" || word == "AVOID_STATIC_OBSTACLES") {
    return avoid_obstacles(behaviour, gain);
  }
  if (word == "AVOID_ROBOTS" || word == "AVOID_ROBOT") return bare(AvoidSoldiers::kName, gain);
  if (word == "INTERCEPT") return bare(PursueEnemy::kName, gain);
  if (word == "MOVE_TO") {
    MoveTo::Config config;
    if (const auto range_m = number(behaviour, "max_sensor_range")) config.max_range_m = *range_m;
    return use_of<MoveTo>(gain, config, classes(behaviour, findings, place));
  }
  if (word == "MOVE_TO_FREE_SPACE") {
    return use_of<MoveToFreeSpace>(gain, {number(behaviour, "horizon").value_or(2.0)});
  }
  if (word == "TELOP" || word == "SCALE_VECTOR") return bare(Telop::kName, gain);
  return std::nullopt;
}

std::optional<Trigger> percept_called(const cdl::Behaviour& behaviour, cdl::Findings& findings,
                                      const cdl::Span& place) {
  if (behaviour.name == "IS_AN_OBJECT") {
    Detect detect{classes(behaviour, findings, place)};
    if (const auto range_m = number(behaviour, "max_sensor_range")) detect.range_m = *range_m;
    return detect;
  }
  if (behaviour.name == "IS_AT_GOAL") {
    return Near{classes(behaviour, findings, place),
                number(behaviour, "success_radius").value_or(0.1), Measured::ToSurface};
  }
  return std::nullopt;
}

}  // namespace tacit
