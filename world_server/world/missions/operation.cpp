#include "world_server/world/missions/operation.h"

#include <algorithm>
#include <array>

namespace tacit {
namespace {

std::size_t team_of(const Stage& stage) {
  return stage.robots() - static_cast<std::size_t>(stage.config().operation.script.extra_count);
}

bool hostile(const OperationConfig& config) { return config.script.extra_colour == "red"; }

/// The longest line of sight that the rules ask for.
double longest_line_m(const OperationConfig& config, const MapPlan& plan) {
  double widest_m = 0.0;
  for (const MapObject& object : plan.objects) {
    widest_m = std::max(widest_m, object.radius_m);
  }
  const OperationReachConfig& reach = config.reach;
  return std::max({reach.pick_up_m + widest_m, reach.drop_m + widest_m, reach.test_m + widest_m,
                   reach.mark_m, reach.intercept_m, config.doorway_range_m, config.exposure_range_m,
                   config.signal.blocked_by_walls ? config.signal.range_m : 0.0});
}

OperatorDesk::Proceed proceed_of(const OperationConfig& config) {
  return config.proceed == "ask" ? OperatorDesk::Proceed::Ask : OperatorDesk::Proceed::AtOnce;
}

Doors doors_of(const Stage& stage) {
  return stage.config().area.doors == "closed" ? Doors::Closed : Doors::Open;
}

}  // namespace

Operation::Operation(Stage& stage, const MapPlan& plan)
    : reach_(stage.config().operation.reach),
      doorway_range_m_(stage.config().operation.doorway_range_m),
      team_(team_of(stage)),
      hostile_(hostile(stage.config().operation)),
      sight_(stage.terrain(), longest_line_m(stage.config().operation, plan), {false, true}),
      objects_(plan, stage.robots()),
      doorways_(plan, doors_of(stage)),
      visits_(plan, stage.config().operation.point_reach_m, stage),
      signals_(stage.config().operation.signal, stage.seed(), stage.robots()),
      exposure_(stage.config().operation.exposure_range_m, team_,
                hostile_ ? stage.robots() : team_),
      desk_(proceed_of(stage.config().operation), team_, stage.robots()),
      finished_(stage.robots(), 0) {
  if (hostile_) {
    for (std::size_t i = team_; i < stage.robots(); ++i) {
      stage.paint(i, {Kind::Enemy, Colour::Red, stage.config().robots.radius_m});
    }
  }
  stage.show_landmarks(objects_.lying());
}

bool Operation::enemies(std::size_t a, std::size_t b) const {
  return hostile_ && in_team(a) != in_team(b);
}

Reach Operation::reach(std::size_t robot, double reach_m, const Stage& stage) {
  sight_.look_from(stage.place_m(robot));
  return {stage.place_m(robot), reach_m, &sight_};
}

void Operation::set_out(Stage& stage) {
  if (stage.tick() == 0) {
    begin(stage);
  }
  desk_.serve(stage);
}

void Operation::begin(Stage& stage) {
  stage.report(OperationBegun{static_cast<std::uint32_t>(team_),
                              static_cast<std::uint32_t>(stage.robots() - team_)});
  visits_.begin(stage);
  exposure_.watch(stage, sight_);
}

void Operation::settle(Stage& stage) {
  visits_.follow(stage);
  intercept(stage);
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (stage.able(i)) {
      act(i, stage);
    }
  }
  signals_.spread(stage, sight_);
  exposure_.watch(stage, sight_);
  stage.show_landmarks(objects_.lying());
}

// Two that intercept each other are both disabled.
void Operation::intercept(Stage& stage) {
  std::vector<std::size_t> able;
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (stage.able(i) && stage.act(i) == Act::Intercept) {
      able.push_back(i);
    }
  }
  for (const std::size_t robot : able) {
    intercept(robot, stage);
  }
}

void Operation::intercept(std::size_t robot, Stage& stage) {
  const Reach arm = reach(robot, reach_.intercept_m, stage);
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (!enemies(robot, i) || !stage.able(i) || !arm.holds(stage.place_m(i))) {
      continue;
    }
    stage.disable(i, Mishap::Enemy);
    stage.deeds(robot).intercepted = true;
    if (stage.holding(i)) {
      lay_down(i, stage);
    }
  }
}

void Operation::act(std::size_t robot, Stage& stage) {
  switch (stage.act(robot)) {
    case Act::PickUp:
      return pick_up(robot, stage);
    case Act::Drop:
      return put_down(robot, stage);
    case Act::Test:
      return test(robot, stage);
    case Act::Mark:
      return mark(robot, true, stage);
    case Act::Unmark:
      return mark(robot, false, stage);
    case Act::Alert:
      return alert(robot, stage);
    case Act::Finish:
      return finish(robot, stage);
    case Act::FinishAll:
      return finish_all(robot, stage);
    case Act::None:
    case Act::Intercept:  // Done before.
    case Act::Signal:     // Done after.
    case Act::Aid:        // Nobody can be helped here.
      return;
  }
}

void Operation::pick_up(std::size_t robot, Stage& stage) {
  if (stage.holding(robot)) {
    return;
  }
  const ObjectId object =
      objects_.take(robot, reach(robot, reach_.pick_up_m, stage), stage.wanted(robot).about);
  if (object != ObjectId{}) {
    stage.set_holding(robot, true);
    stage.deeds(robot).picked_up = true;
    stage.report(ObjectTaken{stage.id_of(robot), object});
  }
}

void Operation::put_down(std::size_t robot, Stage& stage) {
  if (!stage.holding(robot)) {
    return;
  }
  const ObjectId container = objects_.container(reach(robot, reach_.drop_m, stage));
  if (container == ObjectId{}) {
    lay_down(robot, stage);
    return;
  }
  stage.set_holding(robot, false);
  stage.deeds(robot).stored = true;
  stage.report(ObjectStored{stage.id_of(robot), objects_.store(robot), container});
}

void Operation::lay_down(std::size_t robot, Stage& stage) {
  const WorldVec place = stage.place_m(robot);
  stage.set_holding(robot, false);
  stage.deeds(robot).dropped = true;
  stage.report(ObjectDropped{stage.id_of(robot), objects_.put_down(robot, place), place});
}

void Operation::test(std::size_t robot, Stage& stage) {
  const Objects::Test test =
      objects_.test(reach(robot, reach_.test_m, stage), stage.wanted(robot).about);
  if (test.object != ObjectId{}) {
    stage.deeds(robot).tested = test.finding;
    stage.report(ObjectTested{stage.id_of(robot), test.object, test.finding});
  }
}

// A mark that is there already is as good as a new one.
void Operation::mark(std::size_t robot, bool marked, Stage& stage) {
  const std::uint32_t doorway = doorways_.nearest(reach(robot, reach_.mark_m, stage));
  if (doorway == 0) {
    return;
  }
  stage.deeds(robot).marked = true;
  if (doorways_.mark(doorway, marked)) {
    stage.report(DoorwayMarked{stage.id_of(robot), doorway, marked});
  }
}

void Operation::alert(std::size_t robot, Stage& stage) {
  stage.deeds(robot).alerted = true;
  stage.report(Alerted{stage.id_of(robot), stage.wanted(robot).word});
}

void Operation::finish(std::size_t robot, Stage& stage) {
  if (finished_[robot] == 0) {
    finished_[robot] = 1;
    stage.rest(robot);
    stage.report(RobotFinished{stage.id_of(robot)});
  }
}

// An extra robot speaks for the extras.
void Operation::finish_all(std::size_t robot, Stage& stage) {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    if (in_team(i) == in_team(robot) && stage.able(i)) {
      finish(i, stage);
    }
  }
}

void Operation::conclude(Stage& stage) {
  std::size_t able = 0;
  std::size_t busy = 0;
  for (std::size_t i = 0; i < team_; ++i) {
    able += stage.able(i) ? 1 : 0;
    busy += stage.able(i) && finished_[i] == 0 ? 1 : 0;
  }
  if (able == 0) {
    end(stage, Verdict::TeamLost);
  } else if (busy == 0) {
    end(stage, Verdict::Accomplished);
  }
}

void Operation::end(Stage& stage, Verdict verdict) {
  over_ = true;
  stage.report(MissionOver{verdict, stage.tick()});
}

void Operation::perceive(Stage& stage) {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    const WorldPose eye{stage.place_m(i), stage.heading(i)};
    const Spot& spot = visits_.spot(i);
    Percept& percept = stage.percept(i);
    percept.held = percept.holding ? objects_.held_colour(i) : Colour::Orange;
    percept.site = spot.site;
    percept.hallway = spot.site == Site::Hallway ? visits_.sites().hallway(spot.number, eye)
                                                 : std::optional<SeenHallway>();
    doorways_.see(eye, reach(i, doorway_range_m_, stage), percept.doorways);
    percept.heard.assign(signals_.heard(i).begin(), signals_.heard(i).end());
    percept.operated = desk_.input(i, eye.heading);
  }
}

void Operation::add_to(Digest& digest, const Stage& stage) const {
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    digest.add(static_cast<std::uint64_t>(stage.able(i)));
    digest.add(static_cast<std::uint64_t>(stage.holding(i)));
    digest.add(static_cast<std::uint64_t>(finished_[i]));
  }
  objects_.add_to(digest);
  doorways_.add_to(digest);
  visits_.add_to(digest);
  exposure_.add_to(digest);
  desk_.add_to(digest);
}

}  // namespace tacit
