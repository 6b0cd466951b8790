#include "idl/bus/raw_subscriber.h"

#include <gtest/gtest.h>

#include "idl/bus/cdr.h"
#include "idl/bus/publisher.h"
#include "idl/bus/subscriber.h"
#include "idl/wire/teamPubSubTypes.h"
#include "tests/bus/forger.h"
#include "tests/bus/runs.h"
#include "tests/wire/words.h"

namespace tacit {
namespace {

using test::Bytes;
using test::eventually;

template <class Topic>
struct RawInbox {
  explicit RawInbox(Participant& participant, RobotId robot = {})
      : subscriber(participant, robot, mailbox) {}

  bool has(std::size_t count) {
    return eventually([&] {
      for (RawSample& sample : mailbox.collect()) samples.push_back(sample);
      return samples.size() >= count;
    });
  }

  Bell bell;
  Mailbox<RawSample> mailbox{bell};
  std::vector<RawSample> samples;
  RawSubscriber<Topic> subscriber;
};

/// Zero where Fast CDR leaves gaps for alignment as it finds them, and without the bytes that round
/// a sample up on its way.
template <class Word>
Bytes without_gaps(const Bytes& bytes) {
  Word word;
  EXPECT_FALSE(from_cdr(bytes, word));
  Bytes clean;
  to_cdr(word, clean);
  EXPECT_LE(bytes.size() - clean.size(), 3U);
  return clean;
}

/// Publishes `word` and expects the bytes that it is.
template <class Topic>
void expect_untouched(const typename Topic::Word& word, RobotId robot = {}) {
  const test::Run run;
  Participant world(run.world());
  Participant console(run.console());
  Publisher<Topic> out(world, robot);
  RawInbox<Topic> in(console, robot);
  ASSERT_TRUE(eventually([&] { return out.readers() == 1 && in.subscriber.writers() == 1; }));
  ASSERT_TRUE(out.publish(word));
  ASSERT_TRUE(in.has(1));
  Bytes wanted;
  to_cdr(word, wanted);
  EXPECT_EQ(without_gaps<typename Topic::Word>(in.samples[0].bytes), wanted);
  EXPECT_EQ(in.samples[0].robot, robot);
  EXPECT_EQ(Bytes(in.samples[0].bytes.begin(), in.samples[0].bytes.begin() + 4),
            (Bytes{0, 1, 0, 0}));
}

TEST(RawSubscriber, HandsOverAWorldViewAsItWasSent) {
  expect_untouched<topics::WorldView>(test::Words(1).view());
}
TEST(RawSubscriber, HandsOverAStatusAsItWasSent) {
  expect_untouched<topics::Status>(test::Words(2).status());
}
TEST(RawSubscriber, HandsOverEventsAsTheyWereSent) {
  expect_untouched<topics::Events>(test::Words(3).batch());
}
TEST(RawSubscriber, HandsOverTelemetryAsItWasSent) {
  expect_untouched<topics::Telemetry>(test::Words(4).telemetry(), {7});
}
TEST(RawSubscriber, HandsOverATrajectoryAsItWasSent) {
  expect_untouched<topics::Trajectory>(test::Words(5).view());
}

TEST(RawSubscriber, GetsEventsFromBeforeItCame) {
  const test::Run run;
  Participant world(run.world());
  Publisher<topics::Events> out(world);
  test::Words words(6);
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(out.publish(words.batch()));
  Participant console(run.console());
  RawInbox<topics::Events> in(console);
  EXPECT_TRUE(in.has(5));
}

TEST(RawSubscriber, PassesOverASampleTooShortToBeOneAndHandsOverNoise) {
  const test::Run run;
  Participant world(run.world());
  Participant console(run.console());
  RawInbox<topics::WorldView> in(console);
  test::Forger<topics::WorldView, wire::WorldViewPubSubType> forger(world, {});
  ASSERT_TRUE(eventually([&] { return in.subscriber.writers() == 1; }));
  const Bytes noise(200, 0xff);
  ASSERT_TRUE(eventually([&] {
    forger.send({0, 1});
    forger.send(noise);
    return in.mailbox.collect().size() == 1;
  }));
  WorldView view;
  EXPECT_TRUE(from_cdr(noise, view));
}

TEST(RawSubscriber, IsRefusedBesideOneOfWordsOfTheSameType) {
  const test::Run run;
  Participant console(run.console());
  RawInbox<topics::WorldView> raw(console);
  Mailbox<WorldView> mailbox(raw.bell);
  EXPECT_THROW(Subscriber<topics::Trajectory>(console, {}, mailbox), BusError);
  EXPECT_THROW(Subscriber<topics::WorldView>(console, {}, mailbox), BusError);
}

}  // namespace
}  // namespace tacit
