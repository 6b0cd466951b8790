#include "world_server/world/encounters.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tacit {
namespace {

// Bullet keeps contacts over gaps of some millimetres and parts bodies that overlap: room for both.
constexpr double kMargin_m = 0.1;
// How much further apart a body must be to count as far again.
constexpr double kSlack_m = 0.3;
// How far the terrain is looked through. Who goes further in a step is near to everything.
constexpr double kFarthest_m = 3.0;

double gap_m(const Encounters::Body& body, double ways_m) {
  return ways_m + kMargin_m + (body.near ? kSlack_m : 0.0);
}

}  // namespace

Encounters::Encounters(Terrain terrain, double wall_half_thickness_m)
    : terrain_(std::move(terrain)),
      wall_half_thickness_m_(wall_half_thickness_m),
      near_map_(terrain_, kFarthest_m) {}

void Encounters::find(std::span<Body> bodies, double way_m) {
  found_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    found_[i] = static_cast<std::uint8_t>(near_terrain(bodies[i], gap_m(bodies[i], way_m)));
  }
  find_pairs(bodies, way_m);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].near = found_[i] != 0;
  }
}

bool Encounters::near_terrain(const Body& body, double gap_m) const {
  const double reach_m = body.radius_m + gap_m;
  if (near_border(body, reach_m) || reach_m + wall_half_thickness_m_ > kFarthest_m) {
    return true;
  }
  const NearMap::Near near = near_map_.near(body.place_m);
  return std::any_of(near.obstacles.begin(), near.obstacles.end(),
                     [&](std::uint16_t i) {
                       const Disc& disc = terrain_.obstacles[i];
                       const double r = disc.radius_m + reach_m;
                       return (disc.centre_m - body.place_m).squared_norm() <= r * r;
                     }) ||
         std::any_of(near.walls.begin(), near.walls.end(), [&](std::uint16_t i) {
           const double r = wall_half_thickness_m_ + reach_m;
           const WorldVec point = nearest_point(terrain_.walls[i], body.place_m);
           return (point - body.place_m).squared_norm() <= r * r;
         });
}

// Without walls the border is not there to be touched, but beyond it the map of what is near ends.
bool Encounters::near_border(const Body& body, double reach_m) const {
  const WorldVec& p = body.place_m;
  return std::min({p.x(), p.y(), terrain_.width_m - p.x(), terrain_.height_m - p.y()}) <= reach_m;
}

// Bodies keep about the same order from step to step, so that moving each to its place costs
// little.
void Encounters::sort(std::span<const Body> bodies) {
  if (order_.size() != bodies.size()) {
    order_.resize(bodies.size());
    std::iota(order_.begin(), order_.end(), 0U);
  }
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const std::uint32_t body = order_[i];
    std::size_t to = i;
    for (; to > 0 && bodies[order_[to - 1]].place_m.x() > bodies[body].place_m.x(); --to) {
      order_[to] = order_[to - 1];
    }
    order_[to] = body;
  }
}

void Encounters::find_pairs(std::span<const Body> bodies, double way_m) {
  sort(bodies);
  double largest_m = 0.0;
  for (const Body& body : bodies) {
    largest_m = std::max(largest_m, body.radius_m);
  }
  const double farthest_m = 2.0 * (largest_m + way_m) + kMargin_m + kSlack_m;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const Body& left = bodies[order_[i]];
    for (std::size_t j = i + 1; j < order_.size(); ++j) {
      const Body& right = bodies[order_[j]];
      const WorldVec apart = right.place_m - left.place_m;
      if (apart.x() > farthest_m) {
        break;
      }
      const double radii_m = left.radius_m + right.radius_m;
      const auto within = [&](const Body& body) {
        const double r = radii_m + gap_m(body, 2.0 * way_m);
        return apart.squared_norm() <= r * r;
      };
      // Both or neither: who is kept for the other's sake must meet it.
      if (within(left) || within(right)) {
        found_[order_[i]] = found_[order_[j]] = 1;
      }
    }
  }
}

}  // namespace tacit
