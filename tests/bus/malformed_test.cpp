#include <gtest/gtest.h>

#include "idl/bus/subscriber.h"
#include "idl/wire/lockstepPubSubTypes.h"
#include "idl/wire/teamPubSubTypes.h"
#include "tests/bus/forger.h"
#include "tests/bus/runs.h"

namespace tacit {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;
using test::Bytes;
using test::eventually;
using test::Forger;

template <class Topic, class Support>
void expect_refused_and_alive(const Bytes& bad, typename Topic::Word good, auto publish_good) {
  const test::Run run;
  Participant world(run.world());
  Participant agent(run.agent(1));
  Bell bell;
  Mailbox<typename Topic::Word> mailbox(bell);
  Subscriber<Topic> in(world, {1}, mailbox);
  Forger<Topic, Support> forger(agent, {1});
  ASSERT_TRUE(eventually([&] { return in.writers() == 1; }));
  EXPECT_TRUE(eventually([&] {
    forger.send(bad);
    return world.rejections().count() > 0;
  }));
  EXPECT_TRUE(mailbox.collect().empty());
  EXPECT_TRUE(eventually([&] {
    publish_good(forger, good);
    return !mailbox.collect().empty();
  }));
}

/// Little-endian XCDR1 of a word, as a sound sender makes it.
template <class Support, class Wire>
Bytes encoded(Wire wire) {
  Support support;
  SerializedPayload_t payload(support.getSerializedSizeProvider(&wire)());
  support.serialize(&wire, &payload);
  return {payload.data, payload.data + payload.length};
}

wire::Command sound_command() {
  wire::Command wire;
  wire.robot(1);
  return wire;
}

wire::Hello sound_hello() {
  wire::Hello wire;
  wire.robot(1);
  wire.incarnation(1);
  wire.pid(1);
  wire.scenario_digest(std::string(64, '0'));
  return wire;
}

const auto kSendCommand = [](auto& forger, const Command&) {
  forger.send(encoded<wire::CommandPubSubType>(sound_command()));
};
const auto kSendHello = [](auto& forger, const Hello&) {
  forger.send(encoded<wire::HelloPubSubType>(sound_hello()));
};

TEST(MalformedSample, OfBadValuesIsRefusedAndTheNextOneHeard) {
  wire::Command bad = sound_command();
  bad.turn_radps(1e300);
  expect_refused_and_alive<topics::Command, wire::CommandPubSubType>(
      encoded<wire::CommandPubSubType>(bad), {}, kSendCommand);
}

TEST(MalformedSample, ThatEndsTooEarlyIsRefusedAndTheNextOneHeard) {
  Bytes bad = encoded<wire::HelloPubSubType>(sound_hello());
  bad.resize(20);
  expect_refused_and_alive<topics::Hello, wire::HelloPubSubType>(bad, {}, kSendHello);
}

TEST(MalformedSample, OfNoiseIsRefusedAndTheNextOneHeard) {
  Bytes bad(200, 0xff);
  bad[0] = 0;
  bad[1] = 1;
  expect_refused_and_alive<topics::Hello, wire::HelloPubSubType>(bad, {}, kSendHello);
}

TEST(MalformedSample, OfAPlainTypeThatEndsTooEarlyIsRefusedAndTheNextOneHeard) {
  Bytes bad = encoded<wire::CommandPubSubType>(sound_command());
  bad.resize(12);
  expect_refused_and_alive<topics::Command, wire::CommandPubSubType>(bad, {}, kSendCommand);
}

}  // namespace
}  // namespace tacit
