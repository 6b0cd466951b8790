#pragma once

#include "idl/types/command.h"
#include "idl/types/event_batch.h"
#include "idl/types/percept.h"
#include "idl/types/random.h"
#include "idl/types/roster.h"
#include "idl/types/telemetry.h"
#include "idl/types/world_view.h"

namespace tacit::test {

/// Draws words that a sound sender could send.
class Words {
 public:
  explicit Words(std::uint64_t seed) : chance_(seed, "words") {}

  template <class Vec>
  Vec vec(double limit) {
    const double x = chance_.uniform(-limit, limit);
    return {x, chance_.uniform(-limit, limit)};
  }
  RobotId robot() { return {static_cast<std::uint16_t>(1 + chance_.below(65535))}; }
  EnemyId enemy() { return {static_cast<std::uint32_t>(1 + chance_.below(0xfffffffe))}; }
  MineId mine() { return {enemy().value}; }
  Tick tick() { return chance_.bits() >> 1; }
  std::uint64_t bits() { return chance_.bits(); }
  bool flag() { return chance_.below(2) == 1; }
  double positive(double limit) { return chance_.uniform(0.0, limit); }
  Heading heading() { return Heading::from_rad(chance_.uniform(-3.0, 3.0)); }
  template <class Enum>
  Enum code(Enum last) {
    return static_cast<Enum>(chance_.below(static_cast<std::uint64_t>(last) + 1));
  }
  std::size_t count(std::size_t limit) {
    return static_cast<std::size_t>(chance_.below(limit + 1));
  }
  std::string text(std::size_t limit);
  Word word();
  ObjectId object() { return {enemy().value}; }
  /// At most 1 long.
  template <class Vec>
  Vec joystick() {
    return clipped(vec<Vec>(1.0), 1.0);
  }

  Percept percept();
  Command command();
  Order order();
  Hello hello();
  Control control();
  RunStatus status();
  EventBatch batch();
  WorldView view();
  Telemetry telemetry();

 private:
  Happening happening();
  Happening operation();
  SiteEntered site_entered();
  void look_at_a_map(Percept& p);

  Stream chance_;
};

inline std::string Words::text(std::size_t limit) {
  std::string out(count(limit), ' ');
  for (char& c : out) c = static_cast<char>('a' + chance_.below(26));
  return out;
}

inline Word Words::word() {
  std::string out(count(Word::kMaxLength), ' ');
  for (char& c : out) c = static_cast<char>(' ' + chance_.below('~' - ' ' + 1));
  return Word(out);
}

inline Percept Words::percept() {
  Percept p;
  p.robot = robot();
  p.tick = tick();
  p.odometry = {vec<OdometryVec>(1e3), heading()};
  p.velocity_mps = vec<BodyVec>(10.0);
  p.touching = flag();
  p.able = flag();
  p.holding = flag();
  p.held = code(Colour::Grey);
  p.deeds = {
      flag(), flag(), flag(), flag(), flag(), flag(), flag(), flag(), code(Finding::Dangerous)};
  p.sightings.resize(count(Percept::kMaxSightings));
  for (Sighting& s : p.sightings) {
    s = {code(Kind::Object), code(Colour::Grey), vec<BodyVec>(100.0), positive(2.0)};
  }
  p.obstacles.resize(count(Percept::kMaxObstacles));
  for (SeenObstacle& o : p.obstacles) o = {vec<BodyVec>(100.0), positive(5.0)};
  look_at_a_map(p);
  p.heard.resize(count(Percept::kMaxHeard));
  for (Word& heard : p.heard) heard = word();
  p.operated = {flag(), joystick<BodyVec>(), flag(), flag()};
  return p;
}

inline void Words::look_at_a_map(Percept& p) {
  p.site = code(Site::Hallway);
  p.doorways.resize(count(Percept::kMaxDoorways));
  for (SeenDoorway& d : p.doorways) d = {vec<BodyVec>(20.0), vec<BodyVec>(1.0), flag()};
  if (flag()) {
    const Heading along = heading();
    p.hallway = {
        vec<BodyVec>(2.0), {along.cos, along.sin}, positive(40.0), positive(40.0), positive(3.0)};
  }
}

inline Command Words::command() {
  Command c{robot(), tick(), vec<BodyVec>(10.0), positive(3.0) - 1.5, code(Act::FinishAll)};
  if (flag()) c.about = code(Colour::Grey);
  c.word = word();
  return c;
}

inline Order Words::order() { return {robot(), bits(), code(OrderKind::Finish), text(1023)}; }

inline Hello Words::hello() {
  Hello h;
  h.robot = robot();
  h.incarnation = 1 + (bits() >> 1);
  h.pid = static_cast<std::int32_t>(1 + chance_.below(1'000'000));
  h.host = text(255);
  h.version = text(63);
  h.learner = text(31);
  h.driver = text(31);
  for (int i = 0; i < 64; ++i) h.scenario_digest += "0123456789abcdef"[chance_.below(16)];
  return h;
}

inline Control Words::control() {
  return {code(ControlKind::SkipGoal),
          static_cast<std::uint32_t>(1 + chance_.below(1000)),
          positive(100.0),
          {static_cast<std::uint16_t>(chance_.below(65536))},
          joystick<WorldVec>()};
}

inline RunStatus Words::status() {
  RunStatus s;
  s.phase = code(RunPhase::Stopped);
  s.tick = tick();
  s.last_tick = tick();
  s.events = bits();
  s.wall_s = positive(1e5);
  s.first_tick_s = positive(10.0);
  s.resent = static_cast<std::uint32_t>(bits());
  s.rejected = static_cast<std::uint32_t>(bits());
  s.robots = robot().value;
  s.present = static_cast<std::uint16_t>(count(s.robots));
  s.repeatable = flag();
  return s;
}

inline Happening Words::happening() {
  switch (chance_.below(std::variant_size_v<Happening>)) {
    case 0:
      return EnemyCreated{enemy(), code(EnemyKind::Hunter), vec<WorldVec>(500.0)};
    case 1:
      return EnemyIntercepted{enemy(), code(EnemyKind::Hunter), robot(), positive(100.0)};
    case 2:
      return TargetHit{enemy(), positive(10.0)};
    case 3:
      return Collision{robot(), code(Obstruction::Enemy), enemy().value};
    case 4:
      return RobotLost{robot()};
    case 5:
      return RobotBack{robot()};
    case 6:
      return RobotLate{robot()};
    case 7:
      return Checkpoint{bits(), enemy().value, positive(100.0), positive(5.0)};
    case 8:
      return EnemyRetreated{enemy()};
    case 9:
      return MineTaken{robot(), mine()};
    case 10:
      return MineDropped{robot(), mine(), vec<WorldVec>(500.0)};
    case 11:
      return MineStored{robot(), mine(), enemy().value};
    case 12:
      return RobotDisabled{robot(), code(Mishap::Enemy)};
    case 13:
      return RobotRevived{robot(), robot()};
    case 15:
      return ForageBegun{enemy().value};
    case 14:
      return MissionOver{code(Verdict::OutOfTime), tick()};
    case 16:
      return RunEnded{bits()};
    default:
      return operation();
  }
}

inline SiteEntered Words::site_entered() {
  const Site site = code(Site::Hallway);
  return {robot(), site, site == Site::Open ? 0 : enemy().value};
}

inline Happening Words::operation() {
  switch (chance_.below(13)) {
    case 0:
      return OperationBegun{enemy().value, enemy().value};
    case 1:
      return ObjectTaken{robot(), object()};
    case 2:
      return ObjectDropped{robot(), object(), vec<WorldVec>(500.0)};
    case 3:
      return ObjectStored{robot(), object(), object()};
    case 4:
      return ObjectTested{robot(), object(), flag() ? Finding::Harmless : Finding::Dangerous};
    case 5:
      return DoorwayMarked{robot(), enemy().value, flag()};
    case 6:
      return site_entered();
    case 7:
      return PointReached{robot(), enemy().value};
    case 8:
      return Signalled{robot(), word(), enemy().value};
    case 9:
      return Alerted{robot(), word()};
    case 10:
      return RobotExposed{robot(), robot(), flag()};
    case 11:
      return RobotFinished{robot()};
    default:
      return OperatorActed{robot(), code(OperatorAct::SkipGoal), joystick<WorldVec>()};
  }
}

inline EventBatch Words::batch() {
  EventBatch b;
  b.first = bits();
  b.events.resize(count(EventBatch::kMaxEvents));
  for (Event& e : b.events) e = {tick(), happening()};
  return b;
}

inline WorldView Words::view() {
  WorldView v;
  v.tick = tick();
  v.time_s = positive(1e5);
  v.robots.resize(count(100));
  for (ViewedRobot& r : v.robots) {
    r = {robot(),
         {vec<WorldVec>(1e3), heading()},
         vec<WorldVec>(5.0),
         flag(),
         flag(),
         flag(),
         code(Colour::Grey)};
  }
  v.enemies.resize(count(100));
  for (ViewedEnemy& e : v.enemies) e = {enemy(), code(EnemyKind::Hunter), vec<WorldVec>(1e3)};
  v.mines.resize(count(100));
  for (ViewedMine& m : v.mines) m = {mine(), vec<WorldVec>(1e3)};
  v.objects.resize(count(100));
  for (ViewedObject& o : v.objects) {
    o = {object(), vec<WorldVec>(1e3), positive(3.0), code(Colour::Grey)};
  }
  return v;
}

inline Telemetry Words::telemetry() {
  Telemetry t;
  t.robot = robot();
  t.tick = tick();
  t.learner = text(31);
  t.situation = text(31);
  t.role = text(31);
  t.state = text(31);
  t.decisions = bits();
  t.duplicates = bits();
  t.rejected = bits();
  t.shares.resize(count(Telemetry::kMaxShares));
  for (SchemaShare& s : t.shares) s = {text(31), positive(4.0) - 2.0, vec<BodyVec>(2.0)};
  return t;
}

}  // namespace tacit::test
