#include "world_server/world/missions/hunters.h"

#include <limits>

namespace tacit {
namespace {

// How near to its hiding place a retreating hunter is back. [ours: further than a tick's way]
constexpr double kArrived_m = 0.5;

}  // namespace

Hunters::Hunters(const Stage& stage)
    : config_(stage.config().forage.hunters),
      intercept_m_(stage.config().forage.reach.intercept_m),
      inset_m_(2.0 * config_.radius_m),
      everywhere_m_(stage.terrain().width_m + stage.terrain().height_m),
      mind_(stage.config(), stage.terrain()) {
  for (std::int64_t n = 1; n <= config_.count; ++n) {
    const auto owner = static_cast<std::uint64_t>(n);
    hunters_.push_back({Stream(stage.seed(), "hunter", owner),
                        {Stream(stage.seed(), "hunter heading", owner), {}, 0},
                        Doing::Hiding,
                        {},
                        0,
                        {}});
    choose_hiding_place(stage.terrain(), hunters_.back());
    hide(hunters_.back(), 0);
  }
}

// Where an obstacle covers the rim nobody can hide; if chance finds nothing better, the clearest
// of the places it tried will do.
void Hunters::choose_hiding_place(const Terrain& terrain, Hunter& hunter) const {
  constexpr int kTries = 64;
  double clearest_m = -std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < kTries && clearest_m < config_.avoid_reach_m; ++attempt) {
    const WorldVec place = rim_place(terrain, inset_m_, hunter.chance.uniform());
    const double clear_m = clearance_m(terrain, place);
    if (clear_m > clearest_m) {
      hunter.hide_m = place;
      clearest_m = clear_m;
    }
  }
}

void Hunters::hide(Hunter& hunter, Tick from) const {
  const auto choices =
      static_cast<std::uint64_t>(config_.max_wait_ticks - config_.min_wait_ticks + 1);
  hunter.doing = Doing::Hiding;
  hunter.id = {};
  hunter.out_at = from + static_cast<Tick>(config_.min_wait_ticks) + hunter.chance.below(choices);
}

void Hunters::come_out(Stage& stage) {
  for (std::size_t n = 0; n < hunters_.size(); ++n) {
    Hunter& hunter = hunters_[n];
    if (hunter.doing == Doing::Hiding && stage.tick() >= hunter.out_at) {
      hunter.doing = Doing::Hunting;
      hunter.id = EnemyId{++created_};
      outside_.push_back(n);
      stage.enter({hunter.id, EnemyKind::Hunter}, hunter.hide_m, config_.radius_m);
    }
  }
}

void Hunters::drive(Stage& stage) {
  const auto able = [&stage](std::size_t robot) { return stage.able(robot); };
  for (std::size_t k = 0; k < outside_.size(); ++k) {
    Hunter& hunter = outside(k);
    const WorldVec& place = stage.visitor_place_m(k);
    WorldVec goal = hunter.hide_m;
    if (hunter.doing == Doing::Hunting) {
      const std::size_t quarry = stage.nearest_robot(place, everywhere_m_, able);
      goal = quarry == kNobody ? place : stage.place_m(quarry);
    }
    stage.drive_visitor(k, mind_.velocity(hunter.wander, place, goal, stage.tick()));
  }
}

void Hunters::settle(Stage& stage) {
  gone_.assign(outside_.size(), 0);
  intercept(stage);
  strike(stage);
  stage.dismiss(gone_);
  std::size_t k = 0;
  std::erase_if(outside_, [&](std::size_t) { return gone_[k++] != 0; });
}

void Hunters::intercept(Stage& stage) {
  for (std::size_t k = 0; k < outside_.size(); ++k) {
    if (intercepted(k, stage)) {
      gone_[k] = 1;
      choose_hiding_place(stage.terrain(), outside(k));
      hide(outside(k), stage.tick() + 1);
    }
  }
}

bool Hunters::intercepted(std::size_t k, Stage& stage) const {
  const WorldVec& place = stage.visitor_place_m(k);
  const std::size_t robot = stage.nearest_robot(place, intercept_m_, [&stage](std::size_t i) {
    return stage.able(i) && stage.act(i) == Act::Intercept;
  });
  if (robot == kNobody) {
    return false;
  }
  stage.deeds(robot).intercepted = true;
  stage.report(EnemyIntercepted{outside(k).id, EnemyKind::Hunter, stage.id_of(robot),
                                (place - stage.focus_m()).norm()});
  return true;
}

void Hunters::strike(Stage& stage) {
  for (std::size_t k = 0; k < outside_.size(); ++k) {
    if (gone_[k] != 0) {
      continue;
    }
    if (outside(k).doing == Doing::Hunting) {
      touch(k, stage);
    } else if (arrived(k, stage)) {
      gone_[k] = 1;
      stage.report(EnemyRetreated{outside(k).id});
      hide(outside(k), stage.tick() + 1);
    }
  }
}

void Hunters::touch(std::size_t k, Stage& stage) {
  const auto able = [&stage](std::size_t robot) { return stage.able(robot); };
  const std::size_t robot = stage.nearest_robot(stage.visitor_place_m(k), config_.contact_m, able);
  if (robot != kNobody) {
    stage.disable(robot, Mishap::Enemy);
    outside(k).doing = Doing::Retreating;
    choose_hiding_place(stage.terrain(), outside(k));
  }
}

bool Hunters::arrived(std::size_t k, const Stage& stage) const {
  return (stage.visitor_place_m(k) - outside(k).hide_m).norm() <= kArrived_m;
}

void Hunters::add_to(Digest& digest) const {
  for (const Hunter& hunter : hunters_) {
    digest.add(static_cast<std::uint64_t>(hunter.doing));
    digest.add(hunter.hide_m.x());
    digest.add(hunter.hide_m.y());
    digest.add(hunter.out_at);
    digest.add(std::uint64_t{hunter.id.value});
    digest.add(hunter.chance.position());
    digest.add(hunter.wander.chance.position());
  }
}

}  // namespace tacit
