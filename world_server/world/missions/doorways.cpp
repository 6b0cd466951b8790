#include "world_server/world/missions/doorways.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "idl/overlay/openings.h"
#include "world_server/world/missions/operation_map.h"
#include "world_server/world/missions/sites.h"
#include "world_server/world/terrain.h"

namespace tacit {
namespace {

WorldVec middle_of(const PlanDoor& door) { return 0.5 * (place_of(door.from) + place_of(door.to)); }

bool lies_in(const PlanDoor& gap, const PlanDoor& door) {
  const Wall opening{place_of(door.from), place_of(door.to)};
  const WorldVec middle = middle_of(gap);
  return (nearest_point(opening, middle) - middle).norm() <= kDoorReach_m;
}

/// Whether there is a room on one of its sides, a hand's breadth behind the wall.
bool leads_into_a_room(const PlanDoor& door, const Sites& sites) {
  const WorldVec along = unit(place_of(door.to) - place_of(door.from));
  const WorldVec aside = 0.2 * WorldVec{-along.y(), along.x()};
  return sites.at(middle_of(door) + aside).site == Site::Room ||
         sites.at(middle_of(door) - aside).site == Site::Room;
}

/// The openings that count, in order.
std::vector<PlanDoor> openings_of(const MapPlan& plan, Doors doors) {
  if (doors == Doors::Closed) {
    return plan.gaps;
  }
  std::vector<PlanDoor> openings = plan.doors;
  std::copy_if(plan.gaps.begin(), plan.gaps.end(), std::back_inserter(openings),
               [&plan](const PlanDoor& gap) {
                 return std::none_of(plan.doors.begin(), plan.doors.end(),
                                     [&gap](const PlanDoor& door) { return lies_in(gap, door); });
               });
  return openings;
}

}  // namespace

Doorways::Doorways(const MapPlan& plan, Doors doors) {
  const Sites sites(plan);
  for (const PlanDoor& opening : openings_of(plan, doors)) {
    if (leads_into_a_room(opening, sites)) {
      const WorldVec middle = middle_of(opening);
      doorways_.push_back({middle, place_of(opening.to) - middle});
    }
  }
}

void Doorways::see(const WorldPose& eye, const Reach& reach, std::vector<SeenDoorway>& out) {
  seen_.clear();
  for (std::size_t i = 0; i < doorways_.size(); ++i) {
    if (reach.holds(doorways_[i].middle_m)) {
      seen_.emplace_back((doorways_[i].middle_m - eye.position_m).squared_norm(), i);
    }
  }
  std::sort(seen_.begin(), seen_.end());
  seen_.resize(std::min(seen_.size(), Percept::kMaxDoorways));
  out.clear();
  for (const auto& [range2, i] : seen_) {
    const Doorway& doorway = doorways_[i];
    out.push_back({to_body(eye.heading, doorway.middle_m - eye.position_m),
                   to_body(eye.heading, doorway.jamb_m), doorway.marked});
  }
}

std::uint32_t Doorways::nearest(const Reach& reach) const {
  std::uint32_t nearest = 0;
  double nearest2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < doorways_.size(); ++i) {
    const double range2 = (doorways_[i].middle_m - reach.from_m).squared_norm();
    if (range2 < nearest2 && reach.holds(doorways_[i].middle_m)) {
      nearest = static_cast<std::uint32_t>(i + 1);
      nearest2 = range2;
    }
  }
  return nearest;
}

bool Doorways::mark(std::uint32_t number, bool marked) {
  return std::exchange(doorways_.at(number - 1).marked, marked) != marked;
}

void Doorways::add_to(Digest& digest) const {
  for (const Doorway& doorway : doorways_) {
    digest.add(static_cast<std::uint64_t>(doorway.marked));
  }
}

}  // namespace tacit
