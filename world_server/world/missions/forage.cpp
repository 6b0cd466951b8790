#include "world_server/world/missions/forage.h"

#include "world_server/world/missions/mine_field.h"

namespace tacit {
namespace {

BodyGrid bare_ground(const Stage& stage) {
  return {stage.terrain().width_m, stage.terrain().height_m, stage.config().forage.reach.pick_up_m};
}

bool anyone_able(const Stage& stage) {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (stage.able(i)) {
      return true;
    }
  }
  return false;
}

}  // namespace

Forage::Forage(Stage& stage)
    : reach_(stage.config().forage.reach),
      cap_ticks_(static_cast<Tick>(stage.config().forage.cap_ticks)),
      mines_(lay_mines(stage.config(), stage.terrain(), stage.seed()), stage.robots(),
             bare_ground(stage)),
      mud_(stage.config().forage.mud.per_tick, stage.seed(), stage.robots()),
      hunters_(stage),
      was_able_(stage.robots(), 1) {
  const ForageConfig& rules = stage.config().forage;
  stage.show_focus({Kind::Base, Colour::Purple, rules.base.radius_m});
  stage.show_things(mines_.ground(), {Kind::Mine, Colour::Orange, rules.mines.radius_m});
}

void Forage::set_out(Stage& stage) {
  if (stage.tick() == 0) {
    stage.report(ForageBegun{mines_.left()});
  }
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    was_able_[i] = static_cast<std::uint8_t>(stage.able(i));
  }
  hunters_.come_out(stage);
  hunters_.drive(stage);
}

void Forage::settle(Stage& stage) {
  hunters_.settle(stage);
  get_stuck(stage);
  lose_mines(stage);
  aid(stage);
  pick_up(stage);
  put_down(stage);
}

void Forage::get_stuck(Stage& stage) {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (stage.able(i) && mud_.sticks(i)) {
      stage.disable(i, Mishap::Mud);
    }
  }
}

void Forage::lose_mines(Stage& stage) {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (!stage.able(i) && stage.holding(i)) {
      lay_down(i, stage);
    }
  }
}

// Who was disabled when the step began neither helps in it nor is helped by another such robot.
void Forage::aid(Stage& stage) {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (was_able_[i] != 0) {
      continue;
    }
    const std::size_t helper = helper_of(i, stage);
    if (helper != kNobody) {
      stage.revive(i, stage.id_of(helper));
      stage.deeds(helper).revived = true;
    }
  }
}

std::size_t Forage::helper_of(std::size_t robot, const Stage& stage) const {
  return stage.nearest_robot(stage.place_m(robot), reach_.aid_m, [&](std::size_t i) {
    const bool able = was_able_[i] != 0 && stage.able(i);
    return able && (!reach_.revival_needs_aid || stage.act(i) == Act::Aid);
  });
}

void Forage::pick_up(Stage& stage) {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (stage.act(i) != Act::PickUp || !stage.able(i) || stage.holding(i)) {
      continue;
    }
    const MineId mine = mines_.take(i, stage.place_m(i), reach_.pick_up_m);
    if (mine != MineId{}) {
      stage.set_holding(i, true);
      stage.deeds(i).picked_up = true;
      stage.report(MineTaken{stage.id_of(i), mine});
    }
  }
}

void Forage::put_down(Stage& stage) {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (stage.act(i) != Act::Drop || !stage.holding(i)) {
      continue;
    }
    const double to_base_m = (stage.place_m(i) - stage.focus_m()).norm();
    if (to_base_m <= reach_.drop_m) {
      store(i, stage);
    } else {
      lay_down(i, stage);
    }
  }
}

void Forage::lay_down(std::size_t robot, Stage& stage) {
  const WorldVec place = stage.place_m(robot);
  const MineId mine = mines_.put_down(robot, place);
  stage.set_holding(robot, false);
  stage.deeds(robot).dropped = true;
  stage.report(MineDropped{stage.id_of(robot), mine, place});
}

void Forage::store(std::size_t robot, Stage& stage) {
  const MineId mine = mines_.store(robot);
  stage.set_holding(robot, false);
  stage.deeds(robot).stored = true;
  stage.report(MineStored{stage.id_of(robot), mine, mines_.left()});
}

void Forage::conclude(Stage& stage) {
  if (mines_.left() == 0) {
    end(stage, Verdict::Accomplished, stage.tick());
  } else if (!anyone_able(stage)) {
    end(stage, Verdict::TeamLost, cap_ticks_);
  } else if (stage.tick() == cap_ticks_) {
    end(stage, Verdict::OutOfTime, cap_ticks_);
  }
}

void Forage::end(Stage& stage, Verdict verdict, Tick score_ticks) {
  over_ = true;
  stage.report(MissionOver{verdict, score_ticks});
}

void Forage::add_to(Digest& digest, const Stage& stage) const {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    digest.add(static_cast<std::uint64_t>(stage.able(i)));
    digest.add(static_cast<std::uint64_t>(stage.holding(i)));
  }
  mines_.add_to(digest);
  hunters_.add_to(digest);
}

void Forage::show(WorldView& out) const {
  out.mines.assign(mines_.lying().begin(), mines_.lying().end());
}

}  // namespace tacit
