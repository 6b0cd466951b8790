#include "deploy/tacit/plan_wish.h"

#include <charconv>
#include <cmath>
#include <map>
#include <system_error>

#include "idl/types/config_error.h"
#include "idl/types/nearest_word.h"
#include "wizard_service/cbr/features.h"

namespace tacit {
namespace {

MapPoint middle(const std::vector<MapPoint>& points) {
  MapPoint sum;
  for (const MapPoint& p : points) {
    sum.x_m += p.x_m / static_cast<double>(points.size());
    sum.y_m += p.y_m / static_cast<double>(points.size());
  }
  return sum;
}

/// The map's named places, in the world's frame; of two with one name the first.
std::map<std::string, MapPoint> places_of(const MapPlan& map) {
  std::map<std::string, MapPoint> places;
  for (const PlanPoint& point : map.points) places.emplace(point.name, point.at);
  for (const PlanRoom& room : map.rooms) places.emplace(room.name, middle(room.outline));
  for (const MapHallway& hall : map.halls) places.emplace(hall.name, middle(hall.centre_line));
  for (const PlanArea& area : map.areas) places.emplace(area.name, middle(area.points));
  places.erase("");
  return places;
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<MapPoint> numbers(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::optional<double> x = number(text.substr(0, comma));
  const std::optional<double> y = number(text.substr(comma + 1));
  if (!x || !y) return std::nullopt;
  return MapPoint{*x, *y};
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kTold = 20;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kTold; ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  return names.size() > kTold ? text + ", …" : text;
}

MapPoint place_of(std::string_view text, std::string_view whole, const MapPlan& map) {
  if (const std::optional<MapPoint> at = numbers(text)) return *at;
  const std::map<std::string, MapPoint> places = places_of(map);
  const auto named = places.find(std::string(text));
  if (named != places.end()) {
    const MapPoint& shift = map.ground.shift_m;
    return {named->second.x_m - shift.x_m, named->second.y_m - shift.y_m};
  }
  std::vector<std::string> names;
  for (const auto& [name, at] : places) names.push_back(name);
  const std::string meant = did_you_mean(std::string(text), names);
  throw ConfigError("--task " + std::string(whole) + ": found the place \"" + std::string(text) +
                    '"' + (meant.empty() ? "." : meant) +
                    " Wanted X,Y in metres or a place of the map" +
                    (names.empty() ? "; it names none" : ": " + listed(names)));
}

void add_wish(PlacedTask& task, std::string_view wish, std::string_view whole) {
  if (wish == "indoor") {
    task.environment = Environment::Indoor;
  } else if (wish == "outdoor") {
    task.environment = Environment::Outdoor;
  } else if (wish == "landmarks") {
    task.localization = Localization::UseLandmarks;
  } else if (wish == "maps") {
    task.localization = Localization::UseMaps;
  } else if (wish == "enemy" || wish == "no-enemy") {
    task.handles_enemy = wish == "enemy";
  } else {
    throw ConfigError("--task " + std::string(whole) + ": found /" + std::string(wish) +
                      ", wanted /indoor, /outdoor, /landmarks, /maps, /enemy or /no-enemy");
  }
}

}  // namespace

PlacedTask task_of(std::string_view text, const MapPlan& map) {
  const std::size_t at = text.find('@');
  if (at == std::string_view::npos) {
    throw ConfigError("--task: found \"" + std::string(text) +
                      "\", wanted KIND@X,Y or KIND@NAME, as in biohazard@12,8");
  }
  PlacedTask task;
  try {
    task.task = cbr::task_called(text.substr(0, at));
  } catch (const ConfigError& error) {
    throw ConfigError("--task " + std::string(text) + ": " + error.what());
  }
  std::string_view rest = text.substr(at + 1);
  const std::size_t slash = rest.find('/');
  const MapPoint place = place_of(rest.substr(0, slash), text, map);
  task.x_m = place.x_m;
  task.y_m = place.y_m;
  while (rest.find('/') != std::string_view::npos) {
    rest.remove_prefix(rest.find('/') + 1);
    add_wish(task, rest.substr(0, rest.find('/')), text);
  }
  return task;
}

PlanRequest request_of(const PlanWish& wish, const MapPlan& map) {
  PlanRequest request;
  for (const std::string& text : wish.tasks) request.tasks.push_back(task_of(text, map));
  request.robots = wish.robots;
  request.enemy = wish.enemy;
  request.max_velocity_mps = wish.max_velocity_mps;
  request.aggressiveness = wish.aggressiveness;
  request.top = wish.top;
  request.naive = wish.naive;
  return request;
}

}  // namespace tacit
