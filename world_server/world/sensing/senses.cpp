#include "world_server/world/sensing/senses.h"

#include <algorithm>
#include <array>

namespace tacit {
namespace {

// The few farthest go when a sensor is full; what is left keeps its order.
template <class Seen>
void keep_nearest(std::vector<Seen>& seen, std::size_t limit, std::vector<double>& ranges) {
  if (seen.size() <= limit) {
    return;
  }
  ranges.clear();
  for (const Seen& s : seen) {
    ranges.push_back(s.offset_m.squared_norm());
  }
  std::nth_element(ranges.begin(), ranges.begin() + static_cast<std::ptrdiff_t>(limit) - 1,
                   ranges.end());
  const double farthest = ranges[limit - 1];
  // Several can be equally far; the first of them stay.
  auto room =
      std::count(ranges.begin(), ranges.begin() + static_cast<std::ptrdiff_t>(limit), farthest);
  std::erase_if(seen, [&room, farthest](const Seen& s) {
    const double range = s.offset_m.squared_norm();
    return range > farthest || (range == farthest && room-- <= 0);
  });
}

}  // namespace

// Most things are seen in the open, where nothing has to be asked.
inline void Senses::see(const Eye& eye, const WorldVec& offset, const Look& as, Percept& out) {
  const BodyVec seen = to_body(eye.heading, offset);
  if (eye.open || recognisable(offset, seen)) {
    out.sightings.push_back({as.kind, as.colour, seen, as.radius_m});
  }
}

Senses::Senses(const WorldConfig& config, const Terrain& terrain, std::uint64_t seed)
    : sight_(config.sight),
      range2_m2_(config.sight.range_m * config.sight.range_m),
      half_view_cos_(sin_cos(config.sight.field_of_view_deg * (0.5 * kPi / 180.0)).cos),
      panoramic_(config.sight.field_of_view_deg >= 360.0),
      terrain_(&terrain),
      near_(terrain, config.sight.obstacle_range_m),
      line_of_sight_(terrain, config.sight.range_m,
                     {config.sight.blocked_by_obstacles, config.sight.blocked_by_walls}) {
  if (config.sight.range_noise_m > 0.0 || config.sight.bearing_noise_deg > 0.0) {
    for (std::int64_t robot = 1; robot <= config.robots.count; ++robot) {
      noise_.emplace_back(seed, "sight noise", static_cast<std::uint64_t>(robot));
    }
  }
}

void Senses::sense(const Scene& scene, std::size_t robot, Percept& out) {
  out.sightings.clear();
  out.obstacles.clear();
  line_of_sight_.look_from(scene.places_m[robot]);
  const Eye eye{scene.places_m[robot], scene.headings[robot], panoramic_ && line_of_sight_.open()};
  for (const Landmark& landmark : scene.landmarks) {
    const WorldVec to_landmark = landmark.place_m - eye.place_m;
    if (to_landmark.squared_norm() <= range2_m2_) {
      see(eye, to_landmark, landmark.look, out);
    }
  }
  see_bodies(scene, robot, eye, out);
  if (scene.things.grid != nullptr) {
    see_things(scene.things, eye, out);
  }
  range_obstacles(eye, out);
  range_border(eye, out);
  keep_nearest(out.sightings, Percept::kMaxSightings, ranges_);
  keep_nearest(out.obstacles, Percept::kMaxObstacles, ranges_);
  if (!noise_.empty()) {
    blur(robot, out);
  }
}

void Senses::see_bodies(const Scene& scene, std::size_t robot, const Eye& eye, Percept& out) {
  scene.grid->near(eye.place_m, sight_.range_m, [&](std::size_t body, const WorldVec& place_m) {
    const WorldVec offset = place_m - eye.place_m;
    if (offset.squared_norm() > range2_m2_ || body == robot) {
      return;
    }
    see(eye, offset, scene.looks[body], out);
  });
}

void Senses::see_things(const Things& things, const Eye& eye, Percept& out) {
  things.grid->near(eye.place_m, sight_.range_m, [&](std::size_t, const WorldVec& place_m) {
    const WorldVec offset = place_m - eye.place_m;
    if (offset.squared_norm() <= range2_m2_) {
      see(eye, offset, things.look, out);
    }
  });
}

bool Senses::recognisable(const WorldVec& offset, const BodyVec& seen) const {
  const bool in_view = panoramic_ || seen.x() >= half_view_cos_ * seen.norm();
  return in_view && line_of_sight_.clear(offset);
}

void Senses::range_obstacles(const Eye& eye, Percept& out) const {
  const NearMap::Near near = near_.near(eye.place_m);
  for (const std::uint16_t i : near.obstacles) {
    const Disc& disc = terrain_->obstacles[i];
    const WorldVec offset = disc.centre_m - eye.place_m;
    const double reach = sight_.obstacle_range_m + disc.radius_m;
    if (offset.squared_norm() <= reach * reach) {
      out.obstacles.push_back({to_body(eye.heading, offset), disc.radius_m});
    }
  }
  for (const std::uint16_t i : near.walls) {
    const WorldVec offset = nearest_point(terrain_->walls[i], eye.place_m) - eye.place_m;
    if (offset.squared_norm() <= sight_.obstacle_range_m * sight_.obstacle_range_m) {
      out.obstacles.push_back({to_body(eye.heading, offset), 0.0});
    }
  }
}

void Senses::range_border(const Eye& eye, Percept& out) const {
  if (!terrain_->border_walls) {
    return;
  }
  const std::array<WorldVec, 4> to_sides{
      WorldVec{-eye.place_m.x(), 0}, WorldVec{terrain_->width_m - eye.place_m.x(), 0},
      WorldVec{0, -eye.place_m.y()}, WorldVec{0, terrain_->height_m - eye.place_m.y()}};
  for (const WorldVec& offset : to_sides) {
    if (offset.squared_norm() <= sight_.obstacle_range_m * sight_.obstacle_range_m) {
      out.obstacles.push_back({to_body(eye.heading, offset), 0.0});
    }
  }
}

void Senses::blur(std::size_t robot, Percept& out) {
  Stream& noise = noise_[robot];
  const double bearing_noise_rad = sight_.bearing_noise_deg * (kPi / 180.0);
  for (Sighting& s : out.sightings) {
    const double range = s.offset_m.norm();
    const double stretched = std::max(0.0, range + sight_.range_noise_m * noise.normal());
    const Heading turn = Heading::from_rad(bearing_noise_rad * noise.normal());
    const BodyVec turned = from_body<BodyFrame>(turn, s.offset_m);
    s.offset_m = range > 0.0 ? (stretched / range) * turned : turned;
  }
}

}  // namespace tacit
