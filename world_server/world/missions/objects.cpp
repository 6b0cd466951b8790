#include "world_server/world/missions/objects.h"

#include <cassert>

#include "world_server/world/missions/operation_map.h"

namespace tacit {
namespace {

ObjectId id_of(std::size_t index) { return {static_cast<std::uint32_t>(index + 1)}; }

bool suits(Colour colour, std::optional<Colour> wanted) { return !wanted || colour == *wanted; }

}  // namespace

Objects::Objects(const MapPlan& plan, std::size_t robots) : held_(robots, kNone) {
  for (const MapObject& object : plan.objects) {
    objects_.push_back({place_of(object.centre), object.radius_m, object.mobility,
                        map_colour(object.colour).value()});
  }
  survey();
}

template <class Fits>
std::size_t Objects::nearest(const Reach& reach, Fits fits) const {
  std::size_t nearest = kNone;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[i];
    if (object.state != State::Lying || !fits(object)) {
      continue;
    }
    const double to_rim_m = (object.place_m - reach.from_m).norm() - object.radius_m;
    if (to_rim_m < nearest_m && reach.holds(object.place_m, object.radius_m)) {
      nearest = i;
      nearest_m = to_rim_m;
    }
  }
  return nearest;
}

ObjectId Objects::take(std::size_t robot, const Reach& reach, std::optional<Colour> colour) {
  assert(held_[robot] == kNone);
  const std::size_t taken = nearest(reach, [&](const Object& object) {
    return object.mobility == Mobility::Movable && suits(object.colour, colour);
  });
  if (taken == kNone) {
    return {};
  }
  held_[robot] = taken;
  objects_[taken].state = State::Held;
  survey();
  return id_of(taken);
}

ObjectId Objects::container(const Reach& reach) const {
  const std::size_t found =
      nearest(reach, [](const Object& object) { return object.mobility == Mobility::Container; });
  return found == kNone ? ObjectId{} : id_of(found);
}

ObjectId Objects::put_down(std::size_t robot, const WorldVec& place_m) {
  objects_[held_[robot]].place_m = place_m;
  const ObjectId object = release(robot, State::Lying);
  survey();
  return object;
}

ObjectId Objects::store(std::size_t robot) { return release(robot, State::Stored); }

ObjectId Objects::release(std::size_t robot, State state) {
  const std::size_t object = held_[robot];
  assert(object != kNone);
  objects_[object].state = state;
  held_[robot] = kNone;
  return id_of(object);
}

Objects::Test Objects::test(const Reach& reach, std::optional<Colour> colour) {
  const std::size_t tested = nearest(reach, [&](const Object& object) {
    return colour ? object.colour == *colour : object.colour != Colour::Grey;
  });
  if (tested == kNone) {
    return {};
  }
  Object& object = objects_[tested];
  object.colour = Colour::Grey;
  survey();
  return {id_of(tested),
          object.mobility == Mobility::Movable ? Finding::Dangerous : Finding::Harmless};
}

Colour Objects::held_colour(std::size_t robot) const {
  assert(held_[robot] != kNone);
  return objects_[held_[robot]].colour;
}

void Objects::survey() {
  lying_.clear();
  for (const Object& object : objects_) {
    if (object.state == State::Lying) {
      lying_.push_back({object.place_m, {Kind::Object, object.colour, object.radius_m}});
    }
  }
}

void Objects::show(WorldView& out) const {
  for (std::size_t i = 0; i < objects_.size() && out.objects.size() < WorldView::kMaxBodies; ++i) {
    const Object& object = objects_[i];
    if (object.state == State::Lying) {
      out.objects.push_back({id_of(i), object.place_m, object.radius_m, object.colour});
    }
  }
}

void Objects::add_to(Digest& digest) const {
  for (const Object& object : objects_) {
    digest.add(object.place_m.x());
    digest.add(object.place_m.y());
    digest.add(static_cast<std::uint64_t>(object.colour));
    digest.add(static_cast<std::uint64_t>(object.state));
  }
  for (const std::size_t object : held_) {
    digest.add(static_cast<std::uint64_t>(object));
  }
}

}  // namespace tacit
