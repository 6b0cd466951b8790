#include "world_server/world/missions/exposure.h"

namespace tacit {

Exposure::Exposure(double range_m, std::size_t team, std::size_t robots)
    : range_m_(range_m), team_(team), exposed_((robots - team) * team, 0) {}

void Exposure::watch(Stage& stage, LineOfSight& sight) {
  for (std::size_t enemy = 0; enemy * team_ < exposed_.size(); ++enemy) {
    sight.look_from(stage.place_m(team_ + enemy));
    watch(enemy, stage, sight);
  }
}

void Exposure::watch(std::size_t enemy, Stage& stage, const LineOfSight& sight) {
  const std::size_t watcher = team_ + enemy;
  for (std::size_t i = 0; i < team_; ++i) {
    const WorldVec offset = stage.place_m(i) - stage.place_m(watcher);
    const bool seen =
        stage.able(watcher) && offset.squared_norm() <= range_m_ * range_m_ && sight.clear(offset);
    std::uint8_t& exposed = exposed_[enemy * team_ + i];
    if (seen != (exposed != 0)) {
      exposed = static_cast<std::uint8_t>(seen);
      stage.report(RobotExposed{stage.id_of(i), stage.id_of(watcher), seen});
    }
  }
}

void Exposure::add_to(Digest& digest) const {
  for (const std::uint8_t exposed : exposed_) {
    digest.add(static_cast<std::uint64_t>(exposed));
  }
}

}  // namespace tacit
