#include <gtest/gtest.h>

#include <limits>

#include "idl/bus/convert_events.h"
#include "idl/bus/convert_lockstep.h"
#include "idl/bus/convert_team.h"
#include "idl/bus/convert_views.h"
#include "idl/wire/lockstep.h"
#include "idl/wire/team.h"
#include "tests/wire/words.h"

namespace tacit {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

template <class Wire, class Word>
Wire sound(const Word& word) {
  Wire wire;
  to_wire(word, wire);
  Word back;
  EXPECT_FALSE(from_wire(wire, back)) << from_wire(wire, back).what;
  return wire;
}

/// What `from_wire` says to a sound sample after `spoil`.
template <class Word, class Wire, class Spoil>
std::string_view flaw_of(Wire wire, Spoil spoil) {
  spoil(wire);
  Word word;
  return from_wire(wire, word).what;
}

wire::Percept percept() {
  Percept word = test::Words(1).percept();
  word.sightings.resize(3);
  word.obstacles.resize(2);
  word.doorways.resize(2);
  word.heard = {Word("one"), Word("two")};
  word.hallway = {{}, {1.0, 0.0}, 1.0, 1.0, 1.0};
  return sound<wire::Percept>(word);
}
wire::Command command() { return sound<wire::Command>(test::Words(2).command()); }
wire::Hello hello() { return sound<wire::Hello>(test::Words(3).hello()); }
wire::Control control() { return sound<wire::Control>(test::Words(4).control()); }
wire::Order order() { return sound<wire::Order>(test::Words(5).order()); }
wire::RunStatus status() { return sound<wire::RunStatus>(test::Words(6).status()); }

wire::WorldView view() {
  WorldView word;
  word.robots.push_back({{1}, {}, {}, true});
  word.enemies.push_back({{1}, EnemyKind::Hunter, {}});
  word.mines.push_back({{1}, {}});
  word.objects.push_back({{1}, {}, 0.5, Colour::Brown});
  return sound<wire::WorldView>(word);
}

wire::Telemetry telemetry() {
  Telemetry word;
  word.robot = {1};
  word.shares.push_back({"MoveToTarget", 1.0, {}});
  return sound<wire::Telemetry>(word);
}

wire::EventBatch batch(const Happening& what) {
  EventBatch word;
  word.events.push_back({3, what});
  return sound<wire::EventBatch>(word);
}

#define EXPECT_REFUSED(Word, make, spoil) \
  EXPECT_NE(flaw_of<Word>(make, [](auto& w) { spoil; }), "") << #spoil

TEST(Refusal, OfAPerceptNamesEachBadMember) {
  EXPECT_REFUSED(Percept, percept(), w.robot(0));
  EXPECT_REFUSED(Percept, percept(), w.tick(std::uint64_t{1} << 63));
  EXPECT_REFUSED(Percept, percept(), w.odometry_x_m(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.odometry_y_m(1.1e9));
  EXPECT_REFUSED(Percept, percept(), w.odometry_cos(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.odometry_sin(2.0));
  EXPECT_REFUSED(Percept, percept(), w.velocity_x_mps(kInf));
  EXPECT_REFUSED(Percept, percept(), w.velocity_y_mps(-1.1e4));
  EXPECT_REFUSED(Percept, percept(), w.touching(2));
  EXPECT_REFUSED(Percept, percept(), w.able(2));
  EXPECT_REFUSED(Percept, percept(), w.holding(2));
  EXPECT_REFUSED(Percept, percept(), w.held(12));
  EXPECT_REFUSED(Percept, percept(), w.tested(3));
  EXPECT_REFUSED(Percept, percept(), w.sighting_count(129));
  EXPECT_REFUSED(Percept, percept(), w.obstacle_count(65));
  EXPECT_REFUSED(Percept, percept(), w.sighting_kind()[2] = 6);
  EXPECT_REFUSED(Percept, percept(), w.sighting_colour()[2] = 12);
  EXPECT_REFUSED(Percept, percept(), w.sightings()[2].x_m(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.sightings()[2].y_m(-kInf));
  EXPECT_REFUSED(Percept, percept(), w.sightings()[2].radius_m(-1e-9));
  EXPECT_REFUSED(Percept, percept(), w.obstacles()[1].x_m(1.1e6));
  EXPECT_REFUSED(Percept, percept(), w.obstacles()[1].radius_m(kNaN));
}

TEST(Refusal, OfWhatARobotKnowsOfAMapNamesEachBadMember) {
  EXPECT_REFUSED(Percept, percept(), w.site(3));
  EXPECT_REFUSED(Percept, percept(), w.in_hallway(2));
  EXPECT_REFUSED(Percept, percept(), w.hallway_x_m(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.hallway_y_m(1.1e6));
  EXPECT_REFUSED(Percept, percept(), w.hallway_along_x(0.9));
  EXPECT_REFUSED(Percept, percept(), w.hallway_along_y(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.hallway_ahead_m(-1e-9));
  EXPECT_REFUSED(Percept, percept(), w.hallway_behind_m(kInf));
  EXPECT_REFUSED(Percept, percept(), w.hallway_width_m(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.doorway_count(17));
  EXPECT_REFUSED(Percept, percept(), w.doorways()[1].x_m(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.doorways()[1].y_m(kInf));
  EXPECT_REFUSED(Percept, percept(), w.doorways()[1].jamb_x_m(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.doorways()[1].jamb_y_m(-1.1e6));
  EXPECT_REFUSED(Percept, percept(), w.doorway_marked()[1] = 2);
}

TEST(Refusal, OfWhatARobotHearsNamesEachBadMember) {
  EXPECT_REFUSED(Percept, percept(), w.heard_count(5));
  EXPECT_REFUSED(Percept, percept(), w.heard()[1][0] = 31);
  EXPECT_REFUSED(Percept, percept(), w.heard()[1][0] = 127);
  EXPECT_REFUSED(Percept, percept(), w.heard()[1][2] = 0xC3);
  EXPECT_REFUSED(Percept, percept(), w.heard()[1].fill('x'));
  EXPECT_REFUSED(Percept, percept(), w.teleoperated(2));
  EXPECT_REFUSED(Percept, percept(), w.joystick_x(1.1); w.joystick_y(0.0));
  EXPECT_REFUSED(Percept, percept(), w.joystick_x(0.8); w.joystick_y(0.8));
  EXPECT_REFUSED(Percept, percept(), w.joystick_y(kNaN));
  EXPECT_REFUSED(Percept, percept(), w.proceed(2));
  EXPECT_REFUSED(Percept, percept(), w.skip_goal(2));
}

TEST(Refusal, DoesNotLookBeyondTheEndOfAWord) {
  wire::Percept wire = percept();
  wire.heard()[0][5] = 7;
  wire.heard()[2].fill(7);
  Percept word;
  EXPECT_FALSE(from_wire(wire, word));
  EXPECT_EQ(word.heard[0], Word("one"));
}

TEST(Refusal, DoesNotLookAtAHallwayThatIsNotThere) {
  wire::Percept wire = percept();
  wire.in_hallway(0);
  wire.hallway_x_m(kNaN);
  Percept word;
  EXPECT_FALSE(from_wire(wire, word));
}

TEST(Refusal, DoesNotLookBeyondTheCount) {
  wire::Percept wire = percept();
  wire.sightings()[3].x_m(kNaN);
  wire.sighting_kind()[3] = 200;
  Percept word;
  EXPECT_FALSE(from_wire(wire, word));
}

TEST(Refusal, OfACommandNamesEachBadMember) {
  EXPECT_REFUSED(Command, command(), w.robot(0));
  EXPECT_REFUSED(Command, command(), w.tick(~std::uint64_t{0}));
  EXPECT_REFUSED(Command, command(), w.velocity_x_mps(kNaN));
  EXPECT_REFUSED(Command, command(), w.velocity_y_mps(1e300));
  EXPECT_REFUSED(Command, command(), w.turn_radps(-kInf));
  EXPECT_REFUSED(Command, command(), w.act(12));
  EXPECT_REFUSED(Command, command(), w.about(13));
  EXPECT_REFUSED(Command, command(), w.word()[0] = '\n');
  EXPECT_REFUSED(Command, command(), w.word().fill('x'));
}

TEST(Refusal, SaysWhatIsWrong) {
  EXPECT_EQ(flaw_of<Command>(command(), [](auto& w) { w.turn_radps(kNaN); }),
            "turn rate is not within 1e4 rad/s");
}

TEST(Refusal, OfAHelloNamesEachBadMember) {
  EXPECT_REFUSED(Hello, hello(), w.robot(0));
  EXPECT_REFUSED(Hello, hello(), w.incarnation(0));
  EXPECT_REFUSED(Hello, hello(), w.pid(0));
  EXPECT_REFUSED(Hello, hello(), w.pid(-1));
  EXPECT_REFUSED(Hello, hello(), w.host(std::string(256, 'h')));
  EXPECT_REFUSED(Hello, hello(), w.version(std::string(64, 'v')));
  EXPECT_REFUSED(Hello, hello(), w.learner(std::string(32, 'l')));
  EXPECT_REFUSED(Hello, hello(), w.driver(std::string(32, 'd')));
  EXPECT_REFUSED(Hello, hello(), w.scenario_digest("abc"));
  EXPECT_REFUSED(Hello, hello(), w.scenario_digest(std::string(64, 'G')));
}

TEST(Refusal, OfAControlNamesEachBadMember) {
  EXPECT_REFUSED(Control, control(), w.kind(9));
  EXPECT_REFUSED(Control, control(), w.joystick_x(kNaN));
  EXPECT_REFUSED(Control, control(), w.joystick_x(0.8); w.joystick_y(-0.8));
  EXPECT_REFUSED(Control, control(), w.ticks(0));
  EXPECT_REFUSED(Control, control(), w.speed(-0.5));
  EXPECT_REFUSED(Control, control(), w.speed(kNaN));
}

TEST(Refusal, OfAnOrderNamesEachBadMember) {
  EXPECT_REFUSED(Order, order(), w.robot(0));
  EXPECT_REFUSED(Order, order(), w.kind(3));
  EXPECT_REFUSED(Order, order(), w.reason(std::string(1024, 'r')));
}

TEST(Refusal, OfAStatusNamesEachBadMember) {
  EXPECT_REFUSED(RunStatus, status(), w.phase(5));
  EXPECT_REFUSED(RunStatus, status(), w.tick(std::uint64_t{1} << 63));
  EXPECT_REFUSED(RunStatus, status(), w.last_tick(std::uint64_t{1} << 63));
  EXPECT_REFUSED(RunStatus, status(), w.wall_s(-1.0));
  EXPECT_REFUSED(RunStatus, status(), w.first_tick_s(kNaN));
  EXPECT_REFUSED(RunStatus, status(), w.repeatable(2));
  EXPECT_REFUSED(RunStatus, status(), w.robots(1); w.present(2));
}

TEST(Refusal, OfAViewNamesEachBadMember) {
  EXPECT_REFUSED(WorldView, view(), w.time_s(kNaN));
  EXPECT_REFUSED(WorldView, view(), w.tick(std::uint64_t{1} << 63));
  EXPECT_REFUSED(WorldView, view(), w.robots()[0].robot(0));
  EXPECT_REFUSED(WorldView, view(), w.robots()[0].x_m(kNaN));
  EXPECT_REFUSED(WorldView, view(), w.robots()[0].heading_cos(0.5));
  EXPECT_REFUSED(WorldView, view(), w.robots()[0].velocity_y_mps(kInf));
  EXPECT_REFUSED(WorldView, view(), w.robots()[0].present(7));
  EXPECT_REFUSED(WorldView, view(), w.robots()[0].able(2));
  EXPECT_REFUSED(WorldView, view(), w.robots()[0].holding(2));
  EXPECT_REFUSED(WorldView, view(), w.robots()[0].colour(12));
  EXPECT_REFUSED(WorldView, view(), w.objects()[0].number(0));
  EXPECT_REFUSED(WorldView, view(), w.objects()[0].x_m(kNaN));
  EXPECT_REFUSED(WorldView, view(), w.objects()[0].radius_m(-1.0));
  EXPECT_REFUSED(WorldView, view(), w.objects()[0].colour(12));
  EXPECT_REFUSED(WorldView, view(), w.objects().resize(1025));
  EXPECT_REFUSED(WorldView, view(), w.mines()[0].mine(0));
  EXPECT_REFUSED(WorldView, view(), w.mines()[0].x_m(kNaN));
  EXPECT_REFUSED(WorldView, view(), w.mines().resize(1025));
  EXPECT_REFUSED(WorldView, view(), w.enemies()[0].enemy(0));
  EXPECT_REFUSED(WorldView, view(), w.enemies()[0].kind(3));
  EXPECT_REFUSED(WorldView, view(), w.enemies()[0].y_m(1e7));
  EXPECT_REFUSED(WorldView, view(), w.robots().resize(1025));
  EXPECT_REFUSED(WorldView, view(), w.enemies().resize(1025));
}

TEST(Refusal, OfATelemetryNamesEachBadMember) {
  EXPECT_REFUSED(Telemetry, telemetry(), w.robot(0));
  EXPECT_REFUSED(Telemetry, telemetry(), w.tick(std::uint64_t{1} << 63));
  EXPECT_REFUSED(Telemetry, telemetry(), w.learner(std::string(32, 'x')));
  EXPECT_REFUSED(Telemetry, telemetry(), w.situation(std::string(32, 'x')));
  EXPECT_REFUSED(Telemetry, telemetry(), w.role(std::string(32, 'x')));
  EXPECT_REFUSED(Telemetry, telemetry(), w.state(std::string(32, 'x')));
  EXPECT_REFUSED(Telemetry, telemetry(), w.shares().resize(17));
  EXPECT_REFUSED(Telemetry, telemetry(), w.shares()[0].name(std::string(32, 'x')));
  EXPECT_REFUSED(Telemetry, telemetry(), w.shares()[0].gain(kInf));
  EXPECT_REFUSED(Telemetry, telemetry(), w.shares()[0].push_x(kNaN));
}

TEST(Refusal, OfAnEventNamesEachBadMember) {
  const EnemyCreated created{{1}, EnemyKind::Normal, {}};
  const EnemyIntercepted intercepted{{1}, EnemyKind::Normal, {1}, 0.0};
  EXPECT_NE(flaw_of<EventBatch>(batch(created), [](auto& w) { w.events()[0].kind(30); }), "");
  EXPECT_NE(flaw_of<EventBatch>(batch(created), [](auto& w) { w.events()[0].number(0); }), "");
  EXPECT_NE(flaw_of<EventBatch>(batch(created), [](auto& w) { w.events()[0].detail(3); }), "");
  EXPECT_NE(flaw_of<EventBatch>(batch(created), [](auto& w) { w.events()[0].x_m(kNaN); }), "");
  EXPECT_NE(flaw_of<EventBatch>(batch(intercepted), [](auto& w) { w.events()[0].robot(0); }), "");
  EXPECT_NE(flaw_of<EventBatch>(batch(intercepted),
                                [](auto& w) { w.events()[0].distance_to_target_m(-1.0); }),
            "");
  EXPECT_NE(flaw_of<EventBatch>(batch(TargetHit{{1}, 0.0}),
                                [](auto& w) { w.events()[0].distance_to_target_m(kNaN); }),
            "");
  EXPECT_NE(flaw_of<EventBatch>(batch(Collision{{1}, Obstruction::Wall, 0}),
                                [](auto& w) { w.events()[0].detail(4); }),
            "");
  EXPECT_NE(flaw_of<EventBatch>(batch(RobotLost{{1}}), [](auto& w) { w.events()[0].robot(0); }),
            "");
  EXPECT_NE(
      flaw_of<EventBatch>(batch(Checkpoint{}), [](auto& w) { w.events()[0].mean_speed_mps(kInf); }),
      "");
  EXPECT_NE(flaw_of<EventBatch>(batch(RunEnded{}), [](auto& w) { w.events().resize(257); }), "");
}

TEST(Refusal, OfAForageEventNamesEachBadMember) {
  const auto first = [](auto spoil) { return [spoil](auto& w) { spoil(w.events()[0]); }; };
  const auto refused = [&](const Happening& what, auto spoil) {
    return flaw_of<EventBatch>(batch(what), first(spoil)) != "";
  };
  EXPECT_TRUE(refused(EnemyRetreated{{1}}, [](auto& e) { e.number(0); }));
  EXPECT_TRUE(refused(MineTaken{{1}, {1}}, [](auto& e) { e.number(0); }));
  EXPECT_TRUE(refused(MineTaken{{1}, {1}}, [](auto& e) { e.robot(0); }));
  EXPECT_TRUE(refused(MineDropped{{1}, {1}, {}}, [](auto& e) { e.y_m(kInf); }));
  EXPECT_TRUE(refused(MineStored{{1}, {1}, 3}, [](auto& e) { e.robot(0); }));
  EXPECT_TRUE(refused(RobotDisabled{{1}, Mishap::Mud}, [](auto& e) { e.detail(2); }));
  EXPECT_TRUE(refused(RobotRevived{{1}, {2}}, [](auto& e) { e.other_robot(0); }));
  EXPECT_TRUE(refused(MissionOver{}, [](auto& e) { e.detail(3); }));
  EXPECT_TRUE(refused(MissionOver{}, [](auto& e) { e.score_ticks(std::uint64_t{1} << 63); }));
}

TEST(Refusal, OfAnOperationsEventNamesEachBadMember) {
  const auto refused = [](const Happening& what, auto spoil) {
    return flaw_of<EventBatch>(batch(what), [spoil](auto& w) { spoil(w.events()[0]); }) != "";
  };
  EXPECT_TRUE(refused(ObjectTaken{{1}, {1}}, [](auto& e) { e.number(0); }));
  EXPECT_TRUE(refused(ObjectTaken{{1}, {1}}, [](auto& e) { e.robot(0); }));
  EXPECT_TRUE(refused(ObjectDropped{{1}, {1}, {}}, [](auto& e) { e.x_m(kNaN); }));
  EXPECT_TRUE(refused(ObjectStored{{1}, {1}, {2}}, [](auto& e) { e.other(0); }));
  EXPECT_TRUE(refused(ObjectTested{{1}, {1}}, [](auto& e) { e.detail(0); }));
  EXPECT_TRUE(refused(ObjectTested{{1}, {1}}, [](auto& e) { e.detail(3); }));
  EXPECT_TRUE(refused(DoorwayMarked{{1}, 1, true}, [](auto& e) { e.number(0); }));
  EXPECT_TRUE(refused(DoorwayMarked{{1}, 1, true}, [](auto& e) { e.detail(2); }));
  EXPECT_TRUE(refused(SiteEntered{{1}, Site::Room, 1}, [](auto& e) { e.detail(3); }));
  EXPECT_TRUE(refused(SiteEntered{{1}, Site::Room, 1}, [](auto& e) { e.number(0); }));
  EXPECT_TRUE(refused(SiteEntered{{1}, Site::Open, 0}, [](auto& e) { e.number(1); }));
  EXPECT_TRUE(refused(PointReached{{1}, 1}, [](auto& e) { e.number(0); }));
  EXPECT_TRUE(refused(Signalled{{1}, {}, 0}, [](auto& e) { e.robot(0); }));
  EXPECT_TRUE(refused(Signalled{{1}, {}, 0}, [](auto& e) { e.word("\t"); }));
  EXPECT_TRUE(refused(Alerted{{1}, {}}, [](auto& e) { e.word(std::string(64, 'x')); }));
  EXPECT_TRUE(refused(RobotExposed{{1}, {2}, true}, [](auto& e) { e.other_robot(0); }));
  EXPECT_TRUE(refused(RobotExposed{{1}, {2}, true}, [](auto& e) { e.detail(2); }));
  EXPECT_TRUE(refused(RobotFinished{{1}}, [](auto& e) { e.robot(0); }));
  EXPECT_TRUE(refused(OperatorActed{{1}}, [](auto& e) { e.detail(4); }));
  EXPECT_TRUE(refused(OperatorActed{{1}}, [](auto& e) { e.joystick_y(1.1); }));
}

}  // namespace
}  // namespace tacit
