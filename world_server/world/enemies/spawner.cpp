#include "world_server/world/enemies/spawner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tacit {
namespace {

// Distance along `direction` from `x` to the nearer of 0 and `limit`.
double to_side(double x, double direction, double limit) {
  if (direction > 0.0) {
    return (limit - x) / direction;
  }
  return direction < 0.0 ? -x / direction : std::numeric_limits<double>::infinity();
}

}  // namespace

Spawner::Spawner(const WorldConfig& config, const Terrain& terrain, std::uint64_t seed)
    : config_(config.enemies),
      terrain_(&terrain),
      target_m_(config.target.x_m, config.target.y_m),
      tick_s_(config.physics.tick_s),
      waves_(strategy_waves(config.enemies.strategy)),
      chance_(seed, "enemy arrivals") {}

std::span<const Arrival> Spawner::arrivals(Tick tick, std::span<const std::int64_t> alive) {
  arrivals_.clear();
  std::int64_t total = 0;
  for (const std::int64_t count : alive) {
    total += count;
  }
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const double period_s = waves_[i].period_s * config_.period_scale;
    const auto period = static_cast<Tick>(std::max(1.0, std::floor(period_s / tick_s_ + 0.5)));
    if (tick % period == 0) {
      arrive(i, alive[i], config_.max_alive - total - static_cast<std::int64_t>(arrivals_.size()));
    }
  }
  return arrivals_;
}

void Spawner::arrive(std::size_t wave, std::int64_t alive, std::int64_t room) {
  const Wave& w = waves_[wave];
  const std::int64_t count = w.keep > 0 ? std::max<std::int64_t>(0, w.keep - alive) : w.size;
  if (count > room) {
    return;
  }
  const double from_rad =
      w.any_direction ? chance_.uniform(0.0, 2.0 * kPi) : w.from_deg * (kPi / 180.0);
  for (std::int64_t i = 0; i < count; ++i) {
    const bool opposite = w.any_direction && i % 2 == 1;
    appear(wave, opposite ? from_rad + kPi : from_rad);
  }
}

void Spawner::appear(std::size_t wave, double from_rad) {
  arrivals_.push_back({waves_[wave].kind, clear_place(rim(from_rad)), wave});
}

Spawner::Rim Spawner::rim(double from_rad) const {
  const Heading from = Heading::from_rad(from_rad);
  const double x_side = to_side(target_m_.x(), from.cos, terrain_->width_m);
  const double y_side = to_side(target_m_.y(), from.sin, terrain_->height_m);
  const double inset_m = 2.0 * config_.radius_m;
  const WorldVec place = target_m_ + std::min(x_side, y_side) * WorldVec{from.cos, from.sin};
  const WorldVec inside{std::clamp(place.x(), inset_m, terrain_->width_m - inset_m),
                        std::clamp(place.y(), inset_m, terrain_->height_m - inset_m)};
  return {inside, x_side <= y_side ? WorldVec{0, 1} : WorldVec{1, 0}};
}

WorldVec Spawner::clear_place(const Rim& rim) {
  constexpr int kTries = 64;
  double reach_m = config_.spawn_jitter_m;
  WorldVec place = rim.place_m;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const double shift_m = chance_.uniform(-reach_m, reach_m);
    const double inset_m = 2.0 * config_.radius_m;
    const WorldVec shifted = rim.place_m + shift_m * rim.along;
    place = {std::clamp(shifted.x(), inset_m, terrain_->width_m - inset_m),
             std::clamp(shifted.y(), inset_m, terrain_->height_m - inset_m)};
    if (!blocked(place)) {
      return place;
    }
    // An obstacle may cover the whole stretch; look farther along the rim.
    reach_m += 0.5 * config_.radius_m + 0.1;
  }
  return place;
}

bool Spawner::blocked(const WorldVec& place_m) const {
  const auto near = [&](const WorldVec& p, double reach_m) {
    return (p - place_m).squared_norm() < reach_m * reach_m;
  };
  return std::any_of(terrain_->obstacles.begin(), terrain_->obstacles.end(),
                     [&](const Disc& disc) {
                       return near(disc.centre_m, disc.radius_m + config_.radius_m);
                     }) ||
         std::any_of(arrivals_.begin(), arrivals_.end(), [&](const Arrival& other) {
           return near(other.position_m, 2.0 * config_.radius_m);
         });
}

}  // namespace tacit
