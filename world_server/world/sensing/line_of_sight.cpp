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
  discs_.clear();
  walls_.clear();
  const NearMap::Near near = near_.near(eye_m);
  if (blockers_.obstacles) {
    gather_discs(eye_m, near.obstacles);
  }
  if (blockers_.walls) {
    for (const std::uint16_t i : near.walls) {
      const Wall& wall = terrain_->walls[i];
      walls_.push_back({wall.from_m - eye_m, wall.to_m - eye_m});
    }
  }
}

void LineOfSight::gather_discs(const WorldVec& eye_m, std::span<const std::uint16_t> near) {
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (i % 2 == 0) {
      discs_.emplace_back();
    }
    const Disc& disc = terrain_->obstacles[near[i]];
    const auto lane = static_cast<Eigen::Index>(i % 2);
    discs_.back().x[lane] = disc.centre_m.x() - eye_m.x();
    discs_.back().y[lane] = disc.centre_m.y() - eye_m.y();
    discs_.back().r2[lane] = disc.radius_m * disc.radius_m;
  }
}

bool LineOfSight::clear(const WorldVec& offset_m) const {
  return !hidden_by_disc(offset_m) && !hidden_by_wall(offset_m);
}

// The line of length L to (tx, ty) crosses a disc when the disc's centre is abreast of it and
// nearer to it than r. With all three conditions scaled by L, none needs a root or a division.
bool LineOfSight::hidden_by_disc(const WorldVec& offset_m) const {
  using Pair = Eigen::Array2d;
  const Pair tx = Pair::Constant(offset_m.x());
  const Pair ty = Pair::Constant(offset_m.y());
  const Pair length2 = Pair::Constant(offset_m.squared_norm());
  Pair deepest = Pair::Constant(-1.0);
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const DiscPair& disc = discs_[i];
    const Pair along = disc.x * tx + disc.y * ty;
    const Pair across = disc.x * ty - disc.y * tx;
    const Pair inside = disc.r2 * length2 - across * across;
    deepest = deepest.max(along.min(length2 - along).min(inside));
  }
  return deepest.maxCoeff() > 0.0;
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
