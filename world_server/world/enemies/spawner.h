#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "idl/types/event.h"
#include "idl/types/random.h"
#include "world_server/world/enemies/strategy.h"
#include "world_server/world/terrain.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// An enemy about to appear.
struct Arrival {
  EnemyKind kind = EnemyKind::Normal;
  WorldVec position_m;
  std::size_t wave = 0;  ///< Index of the wave it belongs to.
};

/// Decides when and where enemies appear: on the rim of the area, on the line from the target in
/// the wave's direction, shifted along the rim by chance and clear of obstacles.
class Spawner {
 public:
  /// Keeps a reference to `terrain`.
  Spawner(const WorldConfig& config, const Terrain& terrain, std::uint64_t seed);

  /// The arrivals of `tick`; `alive` is the number of living enemies of each wave. Valid until the
  /// next call.
  [[nodiscard]] std::span<const Arrival> arrivals(Tick tick, std::span<const std::int64_t> alive);

  [[nodiscard]] std::size_t waves() const { return waves_.size(); }

 private:
  struct Rim {
    WorldVec place_m;
    WorldVec along;  ///< Unit vector along the border at that place.
  };
  /// Makes the wave arrive, unless it is larger than `room`.
  void arrive(std::size_t wave, std::int64_t alive, std::int64_t room);
  void appear(std::size_t wave, double from_rad);
  [[nodiscard]] Rim rim(double from_rad) const;
  [[nodiscard]] WorldVec clear_place(const Rim& rim);
  [[nodiscard]] bool blocked(const WorldVec& place_m) const;

  EnemyConfig config_;
  const Terrain* terrain_;
  WorldVec target_m_;
  double tick_s_;
  std::span<const Wave> waves_;
  Stream chance_;
  std::vector<Arrival> arrivals_;
};

}  // namespace tacit
