#include "console/debrief/way_points.h"

#include "idl/overlay/tokens.h"

namespace tacit {
namespace {

bool is_way_point(const std::string& name) {
  const std::string called = capitals(name);
  return called.starts_with("WAY") || called.starts_with("ENTRY") || called.starts_with("APPROACH");
}

}  // namespace

WayPoints::WayPoints(const MapPlan& plan) {
  std::uint32_t number = 0;
  for (const PlanPoint& point : plan.points) {
    ++number;
    if (is_way_point(point.name)) points_[number].name = point.name;
  }
}

void WayPoints::add(const Event& event, const TeamWatch& team) {
  const auto* reached = std::get_if<PointReached>(&event.what);
  if (reached == nullptr || !team.in_team(reached->robot)) return;
  const auto point = points_.find(reached->point);
  if (point != points_.end() && !point->second.reached) {
    point->second.reached = Deed{reached->robot, event.tick};
  }
}

void WayPoints::append_to(Checklist& list, const TimeScale& scale) const {
  for (const auto& [number, point] : points_) {
    list.tasks.push_back({"Reach " + point.name, point.reached.has_value(),
                          point.reached ? scale.told(*point.reached, "was there") + '.'
                                        : "No robot of the team was there."});
  }
}

}  // namespace tacit
