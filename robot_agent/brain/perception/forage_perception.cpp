#include "robot_agent/brain/perception/forage_perception.h"

namespace tacit {
namespace {

std::optional<Thing> thing_in(const Sighting& sighting) {
  switch (sighting.kind) {
    case Kind::Mine:
      return Thing::Mine;
    case Kind::Base:
      return Thing::Base;
    case Kind::Enemy:
      return Thing::Enemy;
    case Kind::Teammate:
      if (sighting.colour == Colour::Yellow) return Thing::Disabled;
      return std::nullopt;
    case Kind::Target:
    case Kind::Object:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

ForagePerception::ForagePerception(double teammate_reach_m, const QuarryTrack::Config& track)
    : squared_reach_m2_(teammate_reach_m * teammate_reach_m), track_(track) {
  around_.teammates.reserve(Percept::kMaxSightings);
}

const Surroundings& ForagePerception::look(const Percept& percept) {
  around_.take(percept);
  sort(percept);
  around_.complete(Thing::Base, base_);
  follow_enemy();
  return around_;
}

void ForagePerception::resume(const Memory& memory) {
  track_.resume(memory.track);
  base_.resume(memory.base_m);
}

void ForagePerception::sort(const Percept& percept) {
  around_.nearest = {};
  around_.teammates.clear();
  for (const Sighting& sighting : percept.sightings) {
    const Nearest seen{sighting.offset_m, sighting.offset_m.squared_norm(), sighting.radius_m};
    if (const auto thing = thing_in(sighting)) {
      around_.note(*thing, seen);
    } else if (sighting.kind == Kind::Teammate && seen.squared_range_m2 < squared_reach_m2_) {
      around_.teammates.push_back({seen.offset_m, std::sqrt(seen.squared_range_m2), true});
    }
  }
}

void ForagePerception::follow_enemy() {
  around_.quarry.reset();
  const Nearest& enemy = around_.nearest_of(Thing::Enemy);
  if (!enemy.known()) return;
  const OdometryPose& own = around_.odometry;
  track_.note(around_.tick, own.position_m + from_body<OdometryFrame>(own.heading, enemy.offset_m),
              own.position_m);
  around_.quarry = track_.motion();
}

}  // namespace tacit
