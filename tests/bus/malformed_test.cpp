#include <gtest/gtest.h>

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <cstring>

#include "idl/bus/entities.h"
#include "idl/bus/qos.h"
#include "idl/bus/subscriber.h"
#include "idl/wire/lockstepPubSubTypes.h"
#include "idl/wire/teamPubSubTypes.h"
#include "tests/bus/runs.h"

namespace tacit {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::rtps::SerializedPayload_t;
using test::eventually;

using Bytes = std::vector<std::uint8_t>;

/// Sends any bytes under the name of a wire type.
class RawType final : public dds::TopicDataType {
 public:
  explicit RawType(const char* name) {
    setName(name);
    m_typeSize = 4096;
    m_isGetKeyDefined = false;
  }
  bool serialize(void* data, SerializedPayload_t* payload) override {
    const Bytes& bytes = *static_cast<Bytes*>(data);
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    return true;
  }
  bool deserialize(SerializedPayload_t*, void*) override { return false; }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    const auto size = static_cast<std::uint32_t>(static_cast<Bytes*>(data)->size());
    return [size] { return size; };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

template <class Topic, class Support>
class Forger {
 public:
  Forger(Participant& participant, RobotId robot) {
    dds::TypeSupport type(new RawType(Support().getName()));
    dds::DataWriterQos qos = dds::DATAWRITER_QOS_DEFAULT;
    qos::set_writer(qos, Topic::kPromise);
    qos.data_sharing().off();
    Participant::Entities& entities = participant.entities();
    writer_ =
        entities.publisher->create_datawriter(entities.topic(topic_name<Topic>(robot), type), qos);
  }
  void send(Bytes bytes) { writer_->write(&bytes); }

 private:
  dds::DataWriter* writer_ = nullptr;
};

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
