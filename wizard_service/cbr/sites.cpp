#include "wizard_service/cbr/sites.h"

#include <algorithm>
#include <optional>
#include <string>

#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/places.h"

namespace tacit::cbr {
namespace {

/// Nearer places are the same.
constexpr double kSame = 0.05;

/// How far before a building's way in a robot is out of the way of others.
constexpr double kBefore = 2.0;
/// From one place on a way that is looked at to the next.
constexpr double kStep = 0.25;

/// How far a robot goes into a hallway before its task begins, so that it is in it for certain.
constexpr double kInside = 1.0;
constexpr double kDeepest = 3.0;

/// Far enough for those that stop short of the first to be inside as well.
double inside_for(const Squad& squad) {
  return std::min(kInside + kSpacing * (squad.robots - 1), kDeepest);
}

bool same(const MapPoint& a, const MapPoint& b) { return distance(a, b) < kSame; }

std::string told(const MapPoint& place) { return '(' + place_text(place.x_m, place.y_m) + ')'; }

class Surveyor {
 public:
  Surveyor(const PlanRequest& request, const Terrain& terrain, double inside, Changes& changes)
      : request_(request),
        terrain_(terrain),
        inside_(inside),
        changes_(changes),
        here_(terrain.start()) {}

  Site site_for(std::size_t index) {
    const PlacedTask& task = request_.tasks[index];
    name_ = "Task " + std::to_string(index + 1) + ", " + std::string(word(task.task)) + ',';
    Site site;
    site.out_of_building = in_building_;
    site.at = is_for_building(task) ? in_hallway(task) : reachable({task.x_m, task.y_m});
    site.way = terrain_.route(here_, site.at);
    // Without a way the robot tries all the same, straight on.
    if (site.way.empty()) site.way.push_back(site.at);
    tell_way(site);
    find_outside(site);
    here_ = site.at;
    in_building_ = is_for_building(task) && terrain_.in_building(site.at);
    return site;
  }

 private:
  MapPoint in_hallway(const PlacedTask& task) {
    const MapPoint placed{task.x_m, task.y_m};
    const std::optional<MapPoint> entry = terrain_.hallway_entry(here_, placed, inside_);
    if (!entry) {
      changes_.warn("no-building",
                    name_ + " is for a building with a hallway, and the map has " +
                        (terrain_.has_building() ? "none that can be reached."
                                                 : "none: it may find nothing to go through."));
      return reachable(placed);
    }
    if (!terrain_.in_building(placed)) {
      changes_.mend("no-building", name_ + " lies in no building; the nearest one is meant.",
                    told(placed), told(*entry));
    } else if (!same(placed, *entry)) {
      changes_.adapt(
          "begin-at-entry",
          name_ + " goes through a building from where the robot comes into its hallway.",
          told(placed), told(*entry));
    }
    return *entry;
  }

  MapPoint reachable(const MapPoint& placed) {
    if (terrain_.is_reachable(placed)) return placed;
    const std::optional<MapPoint> near = terrain_.nearest_reachable(placed);
    if (!near) {
      changes_.warn("unreachable-goal", name_ + " lies at " + told(placed) +
                                            ", and the robot can go nowhere from its start.");
      return placed;
    }
    changes_.mend(
        terrain_.is_free(placed) ? "unreachable-goal" : "blocked-goal",
        name_ + (terrain_.is_free(placed) ? " lies where no way leads to from the start."
                                          : " lies in or too close to a wall or an obstacle."),
        told(placed), told(*near));
    return *near;
  }

  /// The last place on the way that lies before the building; on a way within it, that of the task
  /// before.
  void find_outside(Site& site) {
    std::vector<MapPoint> before;
    MapPoint from = here_;
    for (const MapPoint& to : site.way) {
      const double length = distance(from, to);
      for (double along = 0.0; along < length; along += kStep) {
        const MapPoint place{from.x_m + along / length * (to.x_m - from.x_m),
                             from.y_m + along / length * (to.y_m - from.y_m)};
        if (!terrain_.in_building(place)) before.push_back(place);
      }
      from = to;
    }
    constexpr auto kBack = static_cast<std::size_t>(kBefore / kStep);
    if (!before.empty() && terrain_.in_building(site.at)) {
      outside_ = before[before.size() - 1 - std::min(kBack, before.size() - 1)];
    }
    site.outside = outside_.value_or(site.at);
  }

  void tell_way(const Site& site) {
    if (site.way.size() < 2) return;
    std::string way;
    for (const MapPoint& place : site.way) way += (way.empty() ? "" : " ") + told(place);
    changes_.mend("way-round",
                  name_ + " is not in a straight line from where the robot comes from.",
                  told(site.at), way);
  }

  const PlanRequest& request_;
  const Terrain& terrain_;
  double inside_;
  Changes& changes_;
  MapPoint here_;
  std::optional<MapPoint> outside_;
  bool in_building_ = false;
  std::string name_;
};

}  // namespace

bool is_for_building(const PlacedTask& task) {
  return task.task != Task::Waypoints &&
         task.environment.value_or(usual_features(task.task).environment) == Environment::Indoor;
}

std::vector<Site> place_tasks(const PlanRequest& request, const Squad& squad,
                              const Terrain& terrain, Changes& changes) {
  Surveyor surveyor(request, terrain, inside_for(squad), changes);
  std::vector<Site> sites;
  for (const std::size_t task : squad.tasks) sites.push_back(surveyor.site_for(task));
  return sites;
}

}  // namespace tacit::cbr
