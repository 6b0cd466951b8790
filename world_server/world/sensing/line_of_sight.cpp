#include "world_server/world/sensing/line_of_sight.h"

namespace tacit {
namespace {

bool opposite_sides(const WorldVec& along, const WorldVec& a, const WorldVec& b) {
  return (along.cross(a) > 0.0) != (along.cross(b) > 0.0);
}

}  // namespace

LineOfSight::LineOfSight(const Terrain& terrain, double range_m, Blockers blockers)
    : terrain_(&terrain), near_(terrain, range_m), blockers_(blockers) {}

void LineOfSight::look_from(const WorldVec& eye_m) {
  disc_x_.clear();
  disc_y_.clear();
  disc_r2_.clear();
  walls_.clear();
  const NearMap::Near near = near_.near(eye_m);
  if (blockers_.obstacles) {
    for (const std::uint16_t i : near.obstacles) {
      const Disc& disc = terrain_->obstacles[i];
      disc_x_.push_back(disc.centre_m.x() - eye_m.x());
      disc_y_.push_back(disc.centre_m.y() - eye_m.y());
      disc_r2_.push_back(disc.radius_m * disc.radius_m);
    }
  }
  if (blockers_.walls) {
    for (const std::uint16_t i : near.walls) {
      const Wall& wall = terrain_->walls[i];
      walls_.push_back({wall.from_m - eye_m, wall.to_m - eye_m});
    }
  }
}

bool LineOfSight::clear(const WorldVec& offset_m) const {
  return !hidden_by_disc(offset_m) && !hidden_by_wall(offset_m);
}

bool LineOfSight::hidden_by_disc(const WorldVec& offset_m) const {
  const double tx = offset_m.x();
  const double ty = offset_m.y();
  const double length2 = tx * tx + ty * ty;
  int hits = 0;
  const std::size_t count = disc_x_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double along = disc_x_[i] * tx + disc_y_[i] * ty;
    const double across = disc_x_[i] * ty - disc_y_[i] * tx;
    hits += static_cast<int>(along > 0.0) & static_cast<int>(along < length2) &
            static_cast<int>(across * across < disc_r2_[i] * length2);
  }
  return hits != 0;
}

bool LineOfSight::hidden_by_wall(const WorldVec& offset_m) const {
  for (const Wall& wall : walls_) {
    const WorldVec along = wall.to_m - wall.from_m;
    if (opposite_sides(offset_m, wall.from_m, wall.to_m) &&
        opposite_sides(along, -wall.from_m, offset_m - wall.from_m)) {
      return true;
    }
  }
  return false;
}

}  // namespace tacit
