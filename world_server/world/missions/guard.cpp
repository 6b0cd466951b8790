#include "world_server/world/missions/guard.h"

namespace tacit {

Guard::Guard(Stage& stage)
    : spawner_(stage.config(), stage.terrain(), stage.seed()),
      mind_(stage.config(), stage.terrain()),
      alive_(spawner_.waves(), 0) {
  stage.show_focus({Kind::Target, Colour::White, stage.config().target.radius_m});
}

void Guard::set_out(Stage& stage) {
  spawn(stage);
  for (std::size_t k = 0; k < enemies_.size(); ++k) {
    stage.drive_visitor(k, mind_.velocity(enemies_[k], stage.visitor_place_m(k), stage.tick()));
  }
}

void Guard::spawn(Stage& stage) {
  for (const Arrival& arrival : spawner_.arrivals(stage.tick(), alive_)) {
    const EnemyId id{++created_};
    enemies_.push_back({id,
                        arrival.kind,
                        arrival.wave,
                        arrival.position_m,
                        {Stream(stage.seed(), "enemy heading", id.value), {}, 0}});
    ++alive_[arrival.wave];
    stage.enter({id, arrival.kind}, arrival.position_m, stage.config().enemies.radius_m);
  }
}

void Guard::settle(Stage& stage) {
  gone_.assign(enemies_.size(), 0);
  for (std::size_t k = 0; k < enemies_.size(); ++k) {
    if (ends(k, stage)) {
      gone_[k] = 1;
      --alive_[enemies_[k].wave];
    }
  }
  stage.dismiss(gone_);
  std::size_t k = 0;
  std::erase_if(enemies_, [&](const Enemy&) { return gone_[k++] != 0; });
}

// A robot that reaches an enemy destroys it, also when the enemy reaches the target in the same
// tick: "a soldier is always able to kill an enemy when intercepted" (paper, section 2).
bool Guard::ends(std::size_t k, Stage& stage) const {
  const EnemyConfig& rules = stage.config().enemies;
  const WorldVec& place = stage.visitor_place_m(k);
  const double to_target_m = (place - stage.focus_m()).norm();
  const auto anybody = [](std::size_t) { return true; };
  const std::size_t killer = stage.nearest_robot(place, rules.kill_radius_m, anybody);
  if (killer != kNobody) {
    stage.report(
        EnemyIntercepted{enemies_[k].id, enemies_[k].kind, stage.id_of(killer), to_target_m});
    return true;
  }
  if (to_target_m <= rules.hit_radius_m) {
    stage.report(TargetHit{enemies_[k].id, to_target_m});
    return true;
  }
  return false;
}

}  // namespace tacit
