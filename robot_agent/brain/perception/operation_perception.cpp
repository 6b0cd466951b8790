#include "robot_agent/brain/perception/operation_perception.h"

#include <algorithm>
#include <limits>

namespace tacit {
namespace {

/// A robot faces along a hallway when it faces no more than 60 degrees off [ours].
constexpr double kFacingAlong = 0.5;

std::optional<Thing> object_of(Colour colour) {
  switch (colour) {
    case Colour::White:
      return Thing::Home;
    case Colour::Red:
      return Thing::Enemy;
    case Colour::Orange:
      return Thing::Mine;
    case Colour::Purple:
      return Thing::Flag;
    case Colour::Green:
      return Thing::EodArea;
    case Colour::Black:
      return Thing::Rock;
    case Colour::SeaGreen:
      return Thing::Tree;
    case Colour::Brown:
      return Thing::Unknown;
    case Colour::LightBlue:
      return Thing::HidingPlace;
    case Colour::Blue:
    case Colour::Yellow:
    case Colour::Grey:
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Thing> thing_in(const Sighting& sighting) {
  switch (sighting.kind) {
    case Kind::Object:
      return object_of(sighting.colour);
    case Kind::Enemy:
      return Thing::Enemy;
    case Kind::Teammate:
      return sighting.colour == Colour::Yellow ? Thing::Disabled : Thing::Friend;
    case Kind::Mine:
      return Thing::Mine;
    case Kind::Base:
      return Thing::Base;
    case Kind::Target:
      return std::nullopt;
  }
  return std::nullopt;
}

/// Whether the straight way to `offset_m` leads through an opening.
bool through(const SeenDoorway& doorway, const BodyVec& offset_m) {
  const BodyVec one_m = doorway.offset_m + doorway.jamb_m;
  const BodyVec other_m = doorway.offset_m - doorway.jamb_m;
  const BodyVec wall = other_m - one_m;
  const bool between = offset_m.cross(one_m) * offset_m.cross(other_m) < 0.0;
  const bool beyond = wall.cross(-one_m) * wall.cross(offset_m - one_m) < 0.0;
  return between && beyond;
}

}  // namespace

OperationPerception::OperationPerception(const WorldPose& start) : start_(start) {
  track_.reserve(kTrackTicks + 2);
  around_.premises.friends.reserve(Percept::kMaxSightings);
  around_.premises.enemies.reserve(Percept::kMaxSightings);
}

const Surroundings& OperationPerception::look(const Percept& percept) {
  around_.take(percept);
  Premises& here = around_.premises;
  here.held = percept.held;
  here.site = percept.site;
  here.doorways = percept.doorways;
  here.operated = percept.operated;
  sort(percept);
  around_.complete(Thing::Home, home_);
  find_pose();
  follow_hallway(percept);
  follow_rooms(percept.site);
  listen(percept);
  remember_way();
  return around_;
}

void OperationPerception::sort(const Percept& percept) {
  Premises& here = around_.premises;
  around_.nearest = {};
  here.friends.clear();
  here.enemies.clear();
  for (const Sighting& sighting : percept.sightings) {
    if (sighting.kind == Kind::Teammate) {
      here.friends.push_back({sighting.offset_m, sighting.radius_m});
    } else if (sighting.kind == Kind::Enemy) {
      here.enemies.push_back({sighting.offset_m, sighting.radius_m});
    }
    if (const auto thing = thing_in(sighting)) {
      const Nearest seen{sighting.offset_m, sighting.offset_m.squared_norm(), sighting.radius_m};
      around_.note(*thing, seen);
      if (thing == Thing::Unknown && is_here(seen.offset_m)) around_.note(Thing::UnknownHere, seen);
    }
  }
}

bool OperationPerception::is_here(const BodyVec& offset_m) const {
  const auto& doorways = around_.premises.doorways;
  return std::none_of(doorways.begin(), doorways.end(),
                      [&offset_m](const SeenDoorway& each) { return through(each, offset_m); });
}

void OperationPerception::find_pose() {
  const OdometryPose& own = around_.odometry;
  const Heading& at = start_.heading;
  const BodyVec moved_m{own.position_m.x(), own.position_m.y()};
  around_.premises.pose = {start_.position_m + from_body<WorldFrame>(at, moved_m),
                           {at.cos * own.heading.cos - at.sin * own.heading.sin,
                            at.sin * own.heading.cos + at.cos * own.heading.sin}};
}

void OperationPerception::follow_hallway(const Percept& percept) {
  Premises& here = around_.premises;
  here.hallway = percept.hallway;
  if (!here.hallway) return;
  const BodyVec& along = here.hallway->along;
  if (std::abs(along.x()) < kFacingAlong) return;
  here.course =
      from_body<OdometryFrame>(around_.odometry.heading, along.x() < 0.0 ? -along : along);
}

// A robot that comes into a room came through the nearest doorway.
void OperationPerception::follow_rooms(Site site) {
  Premises& here = around_.premises;
  const bool came_in = site == Site::Room && last_site_ != Site::Room;
  last_site_ = site;
  if (!came_in || here.doorways.empty()) return;
  const auto nearest = std::min_element(
      here.doorways.begin(), here.doorways.end(), [](const SeenDoorway& a, const SeenDoorway& b) {
        return a.offset_m.squared_norm() < b.offset_m.squared_norm();
      });
  const OdometryPose& own = around_.odometry;
  const OdometryVec moved_m = track_.empty() ? OdometryVec{} : own.position_m - track_.front();
  OdometryVec inwards = from_body<OdometryFrame>(
      own.heading, unit(BodyVec{-nearest->jamb_m.y(), nearest->jamb_m.x()}));
  if (inwards.dot(moved_m) < 0.0) inwards = -inwards;
  here.entrance = {own.position_m + from_body<OdometryFrame>(own.heading, nearest->offset_m),
                   inwards};
}

void OperationPerception::listen(const Percept& percept) {
  for (const Word& word : percept.heard) {
    std::erase_if(heard_, [&word](const Heard& each) { return each.word == word; });
    heard_.push_back({word, percept.tick});
  }
  std::erase_if(heard_,
                [&percept](const Heard& each) { return percept.tick >= each.tick + kRingTicks; });
  std::vector<Word>& words = around_.premises.heard;
  words.clear();
  for (const Heard& each : heard_) words.push_back(each.word);
}

void OperationPerception::remember_way() {
  track_.insert(track_.begin(), around_.odometry.position_m);
  if (track_.size() > kTrackTicks + 1) track_.pop_back();
  around_.premises.track = track_;
}

OperationPerception::Memory OperationPerception::memory() const {
  return {home_.place_m(), around_.premises.course, around_.premises.entrance};
}

void OperationPerception::resume(const Memory& memory) {
  home_.resume(memory.home_m);
  around_.premises.course = memory.course;
  around_.premises.entrance = memory.entrance;
}

}  // namespace tacit
