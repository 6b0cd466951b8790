#include <gtest/gtest.h>

#include "idl/bus/convert_events.h"
#include "idl/bus/convert_lockstep.h"
#include "idl/bus/convert_team.h"
#include "idl/bus/convert_views.h"
#include "idl/wire/lockstepPubSubTypes.h"
#include "idl/wire/teamPubSubTypes.h"
#include "tests/wire/words.h"

namespace tacit {
namespace {

constexpr int kDraws = 200;

using eprosima::fastrtps::rtps::SerializedPayload_t;

std::vector<std::uint8_t> bytes_of(auto support, auto wire) {
  SerializedPayload_t payload(support.getSerializedSizeProvider(&wire)());
  EXPECT_TRUE(support.serialize(&wire, &payload));
  return {payload.data, payload.data + payload.length};
}

template <class Wire, class Support>
Wire from_bytes(Support support, std::vector<std::uint8_t> bytes) {
  SerializedPayload_t payload(static_cast<std::uint32_t>(bytes.size()));
  payload.length = payload.max_size;
  std::copy(bytes.begin(), bytes.end(), payload.data);
  Wire wire;
  EXPECT_TRUE(support.deserialize(&payload, &wire));
  return wire;
}

/// The bits of every member that crosses the wire.
template <class Wire, class Support, class Word>
std::vector<std::uint8_t> bits_of(const Word& word) {
  Wire wire;
  to_wire(word, wire);
  return bytes_of(Support(), wire);
}

/// word -> wire -> bytes -> wire -> word, into a word that holds something else before.
template <class Wire, class Support, class Word>
void expect_round_trip(const Word& sent, Word received) {
  const auto bytes = bits_of<Wire, Support>(sent);
  const Flaw flaw = from_wire(from_bytes<Wire>(Support(), bytes), received);
  ASSERT_FALSE(flaw) << flaw.what;
  const auto again = bits_of<Wire, Support>(received);
  EXPECT_EQ(bytes, again);
}

TEST(RoundTrip, KeepsEveryBitOfAPercept) {
  test::Words words(1);
  for (int i = 0; i < kDraws; ++i) {
    expect_round_trip<wire::Percept, wire::PerceptPubSubType>(words.percept(), words.percept());
  }
}

TEST(RoundTrip, KeepsTheMembersOfAPercept) {
  const Percept sent = test::Words(2).percept();
  wire::Percept wire;
  to_wire(sent, wire);
  Percept got;
  ASSERT_FALSE(from_wire(wire, got));
  EXPECT_EQ(got.robot, sent.robot);
  EXPECT_EQ(got.tick, sent.tick);
  EXPECT_EQ(got.odometry.position_m, sent.odometry.position_m);
  EXPECT_EQ(got.velocity_mps, sent.velocity_mps);
  EXPECT_EQ(got.able, sent.able);
  EXPECT_EQ(got.holding, sent.holding);
  EXPECT_EQ(got.deeds, sent.deeds);
  ASSERT_EQ(got.sightings.size(), sent.sightings.size());
  for (std::size_t i = 0; i < got.sightings.size(); ++i) {
    EXPECT_EQ(got.sightings[i].kind, sent.sightings[i].kind);
    EXPECT_EQ(got.sightings[i].colour, sent.sightings[i].colour);
    EXPECT_EQ(got.sightings[i].offset_m, sent.sightings[i].offset_m);
    EXPECT_EQ(got.sightings[i].radius_m, sent.sightings[i].radius_m);
  }
  EXPECT_EQ(got.obstacles.size(), sent.obstacles.size());
}

/// A percept of a robot in an operation, with something in each of its members.
Percept on_a_map() {
  Percept p = test::Words(12).percept();
  p.held = Colour::SeaGreen;
  p.deeds = {};
  p.deeds.marked = true;
  p.deeds.tested = Finding::Dangerous;
  p.site = Site::Hallway;
  p.hallway = {{1.0, 2.0}, {0.6, 0.8}, 3.0, 4.0, 5.0};
  p.doorways = {{{6.0, 7.0}, {0.0, 0.5}, true}, {{8.0, 9.0}, {0.4, 0.0}, false}};
  p.heard = {Word("Cover me."), Word()};
  p.operated = {true, {0.3, -0.4}, false, true};
  return p;
}

TEST(RoundTrip, KeepsWhatARobotKnowsInAnOperation) {
  const Percept sent = on_a_map();
  wire::Percept wire;
  to_wire(sent, wire);
  Percept got = test::Words(13).percept();
  ASSERT_FALSE(from_wire(wire, got));
  EXPECT_EQ(got.held, sent.held);
  EXPECT_EQ(got.deeds, sent.deeds);
  EXPECT_EQ(got.site, sent.site);
  EXPECT_EQ(got.heard, sent.heard);
  EXPECT_TRUE(got.operated.teleoperated);
  EXPECT_EQ(got.operated.joystick, sent.operated.joystick);
  EXPECT_FALSE(got.operated.proceed);
  EXPECT_TRUE(got.operated.skip_goal);
}

TEST(RoundTrip, KeepsTheDoorwaysAndTheHallwayOfAPercept) {
  const Percept sent = on_a_map();
  wire::Percept wire;
  to_wire(sent, wire);
  Percept got;
  ASSERT_FALSE(from_wire(wire, got));
  ASSERT_TRUE(got.hallway);
  EXPECT_EQ(got.hallway->offset_m, sent.hallway->offset_m);
  EXPECT_EQ(got.hallway->along, sent.hallway->along);
  EXPECT_EQ(got.hallway->ahead_m, 3.0);
  EXPECT_EQ(got.hallway->behind_m, 4.0);
  EXPECT_EQ(got.hallway->width_m, 5.0);
  ASSERT_EQ(got.doorways.size(), 2U);
  EXPECT_EQ(got.doorways[0].jamb_m, sent.doorways[0].jamb_m);
  EXPECT_TRUE(got.doorways[0].marked);
  EXPECT_EQ(got.doorways[1].offset_m, sent.doorways[1].offset_m);
}

TEST(RoundTrip, ForgetsTheHallwayOfThePerceptBefore) {
  Percept outside = on_a_map();
  outside.hallway.reset();
  wire::Percept wire;
  to_wire(on_a_map(), wire);
  to_wire(outside, wire);
  Percept got = on_a_map();
  ASSERT_FALSE(from_wire(wire, got));
  EXPECT_FALSE(got.hallway);
}

TEST(RoundTrip, KeepsEveryBitOfACommand) {
  test::Words words(3);
  for (int i = 0; i < kDraws; ++i) {
    expect_round_trip<wire::Command, wire::CommandPubSubType>(words.command(), words.command());
  }
}

TEST(RoundTrip, KeepsTheMembersOfACommand) {
  const Command sent = test::Words(4).command();
  wire::Command wire;
  to_wire(sent, wire);
  Command got;
  ASSERT_FALSE(from_wire(wire, got));
  EXPECT_EQ(got.robot, sent.robot);
  EXPECT_EQ(got.tick, sent.tick);
  EXPECT_EQ(got.velocity_mps, sent.velocity_mps);
  EXPECT_EQ(got.turn_radps, sent.turn_radps);
}

TEST(RoundTrip, KeepsWhatACommandIsAbout) {
  Command sent{{1}, 2, {}, 0.0, Act::Signal, Colour::Grey, Word("Follow me.")};
  wire::Command wire;
  to_wire(sent, wire);
  Command got;
  ASSERT_FALSE(from_wire(wire, got));
  EXPECT_EQ(got.act, Act::Signal);
  EXPECT_EQ(got.about, Colour::Grey);
  EXPECT_EQ(got.word, sent.word);
  sent.about.reset();
  sent.word = {};
  to_wire(sent, wire);
  ASSERT_FALSE(from_wire(wire, got));
  EXPECT_FALSE(got.about);
  EXPECT_TRUE(got.word.empty());
}

TEST(RoundTrip, KeepsEveryBitOfAnOrder) {
  test::Words words(5);
  for (int i = 0; i < kDraws; ++i) {
    expect_round_trip<wire::Order, wire::OrderPubSubType>(words.order(), words.order());
  }
}

TEST(RoundTrip, KeepsEveryBitOfAHello) {
  test::Words words(6);
  for (int i = 0; i < kDraws; ++i) {
    expect_round_trip<wire::Hello, wire::HelloPubSubType>(words.hello(), words.hello());
  }
}

TEST(RoundTrip, KeepsEveryBitOfAControl) {
  test::Words words(7);
  for (int i = 0; i < kDraws; ++i) {
    expect_round_trip<wire::Control, wire::ControlPubSubType>(words.control(), words.control());
  }
}

TEST(RoundTrip, KeepsEveryBitOfAStatus) {
  test::Words words(8);
  for (int i = 0; i < kDraws; ++i) {
    expect_round_trip<wire::RunStatus, wire::RunStatusPubSubType>(words.status(), words.status());
  }
}

TEST(RoundTrip, KeepsEveryEvent) {
  test::Words words(9);
  for (int i = 0; i < kDraws; ++i) {
    const EventBatch sent = words.batch();
    wire::EventBatch wire;
    to_wire(sent, wire);
    EventBatch got = words.batch();
    ASSERT_FALSE(
        from_wire(from_bytes<wire::EventBatch>(wire::EventBatchPubSubType(),
                                               bytes_of(wire::EventBatchPubSubType(), wire)),
                  got));
    EXPECT_EQ(got.first, sent.first);
    EXPECT_EQ(got.events, sent.events);
  }
}

TEST(RoundTrip, KeepsEveryBitOfAView) {
  test::Words words(10);
  for (int i = 0; i < kDraws; ++i) {
    expect_round_trip<wire::WorldView, wire::WorldViewPubSubType>(words.view(), words.view());
  }
}

TEST(RoundTrip, KeepsEveryBitOfATelemetry) {
  test::Words words(11);
  for (int i = 0; i < kDraws; ++i) {
    expect_round_trip<wire::Telemetry, wire::TelemetryPubSubType>(words.telemetry(),
                                                                  words.telemetry());
  }
}

TEST(RoundTrip, CutsAReasonThatIsTooLongToSend) {
  Order order{{1}, 0, OrderKind::Refuse, std::string(5000, 'x')};
  wire::Order wire;
  to_wire(order, wire);
  ASSERT_FALSE(from_wire(wire, order));
  EXPECT_EQ(order.reason, std::string(1023, 'x'));
}

}  // namespace
}  // namespace tacit
