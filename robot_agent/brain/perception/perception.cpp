#include "robot_agent/brain/perception/perception.h"

#include <optional>

namespace tacit {

Perception::Perception(const EnemyGroups& groups, const Occlusion& occlusion, Attention attention)
    : groups_(groups), occlusion_(occlusion), attention_(attention) {
  around_.teammates.reserve(Percept::kMaxSightings);
  if (attention == Attention::NoEnemies) return;
  around_.enemies.reserve(Percept::kMaxSightings);
  around_.groups.reserve(Percept::kMaxSightings);
}

const Surroundings& Perception::look(const Percept& percept) {
  around_.tick = percept.tick;
  around_.odometry = percept.odometry;
  around_.obstacles = percept.obstacles;
  sort(percept);
  around_.target_m = target_.from(percept.odometry);
  if (attention_ == Attention::Everything) {
    groups_.find(around_.enemies, around_.groups);
    around_.open_group = nearest_open_group();
  }
  return around_;
}

void Perception::sort(const Percept& percept) {
  around_.teammates.clear();
  around_.enemies.clear();
  std::optional<Seen> target;
  for (const Sighting& sighting : percept.sightings) {
    const Seen seen{sighting.offset_m, sighting.offset_m.norm(), sighting.colour != Colour::Yellow};
    switch (sighting.kind) {
      case Kind::Target:
        if (!target || nearer(seen, *target)) target = seen;
        break;
      case Kind::Teammate:
        around_.teammates.push_back(seen);
        break;
      case Kind::Enemy:
        if (attention_ == Attention::Everything) around_.enemies.push_back(seen);
        break;
      case Kind::Mine:
      case Kind::Base:
      case Kind::Object:
        break;
    }
  }
  if (target) target_.see(percept.odometry, target->offset_m);
}

// Looks for occlusion only where the answer hangs on it, since that is the costly part.
const EnemyGroup* Perception::nearest_open_group() const {
  const EnemyGroup* best = nullptr;
  for (const EnemyGroup& group : around_.groups) {
    if (best != nullptr && !nearer(group.nearest, best->nearest)) continue;
    if (!occlusion_.occluded(group.centroid_m, around_.teammates)) best = &group;
  }
  return best;
}

}  // namespace tacit
