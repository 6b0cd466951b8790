#include <gtest/gtest.h>

#include <fastdds/dds/topic/TypeSupport.hpp>

#include <stdexcept>

#include "idl/bus/entities.h"
#include "idl/bus/publisher.h"
#include "idl/wire/lockstepPubSubTypes.h"
#include "idl/wire/teamPubSubTypes.h"
#include "tests/bus/runs.h"

namespace tacit {
namespace {

namespace dds = eprosima::fastdds::dds;

/// A wire type that makes Fast DDS throw when it is sent, before anything was taken for the sample
/// that would have to be given back: it is asked for a key.
template <class Support>
class Unsendable final : public Support {
 public:
  Unsendable() { this->m_isGetKeyDefined = true; }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override {
    throw std::runtime_error("a fault of the bus");
  }
  /// What is not plain cannot be lent.
  bool is_plain() const override { return false; }
};

/// Publishes a word that cannot be sent.
template <class Topic, class Support>
bool publish_unsendable(const Identity& from, Promise promise = Topic::kPromise) {
  Participant participant(from);
  dds::TypeSupport type(new Unsendable<Support>());
  participant.entities().topic(topic_name<Topic>({1}), type);
  Publisher<Topic> out(participant, {1}, promise);
  return out.publish({});
}

TEST(FaultOfTheBus, IsTheLossOfAPerceptThatGoesThroughSharedMemory) {
  const test::Run run;
  EXPECT_FALSE((publish_unsendable<topics::Percept, wire::PerceptPubSubType>(run.world())));
}

TEST(FaultOfTheBus, IsToldToTheSenderOfAPerceptThatDoesNot) {
  const test::Run run;
  EXPECT_THROW(
      (publish_unsendable<topics::Percept, wire::PerceptPubSubType>(run.world(), Promise::Answer)),
      std::runtime_error);
}

TEST(FaultOfTheBus, IsToldToTheSenderOfACommand) {
  const test::Run run;
  EXPECT_THROW((publish_unsendable<topics::Command, wire::CommandPubSubType>(run.agent(1))),
               std::runtime_error);
}

TEST(FaultOfTheBus, IsToldToTheSenderOfEvents) {
  const test::Run run;
  EXPECT_THROW((publish_unsendable<topics::Events, wire::EventBatchPubSubType>(run.world())),
               std::runtime_error);
}

}  // namespace
}  // namespace tacit
