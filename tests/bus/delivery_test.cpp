#include <gtest/gtest.h>

#include "idl/bus/publisher.h"
#include "idl/bus/subscriber.h"
#include "tests/bus/runs.h"

namespace tacit {
namespace {

using test::eventually;

/// Collects what a subscriber hands over.
template <class Topic>
struct Inbox {
  using Word = typename Topic::Word;
  explicit Inbox(Participant& participant, RobotId robot = {})
      : subscriber(participant, robot, mailbox) {}

  bool has(std::size_t count) {
    return eventually([&] {
      for (Word& word : mailbox.collect()) words.push_back(word);
      return words.size() >= count;
    });
  }

  Bell bell;
  Mailbox<Word> mailbox{bell};
  std::vector<Word> words;
  Subscriber<Topic> subscriber;
};

EventBatch batch(std::uint64_t first) {
  return {first, {{first, EnemyCreated{{static_cast<std::uint32_t>(first + 1)}, {}, {}}}}};
}

TEST(Delivery, OfAPerceptNeedsNoNetwork) {
  const test::Run run;
  Participant world(run.world());
  Participant agent(run.agent(1));
  Publisher<topics::Percept> out(world, {1});
  Inbox<topics::Percept> in(agent, {1});
  ASSERT_TRUE(eventually([&] { return out.readers() == 1 && in.subscriber.writers() == 1; }));
  EXPECT_GE(leftovers(run.nonce()).size(), 2U) << "no memory is shared";

  Percept percept;
  percept.robot = {1};
  percept.sightings.resize(3);
  for (Tick tick = 0; tick < 100; ++tick) {
    percept.tick = tick;
    ASSERT_TRUE(out.publish(percept));
    ASSERT_TRUE(in.has(tick + 1)) << tick;
  }
  EXPECT_EQ(in.words.back().tick, 99U);
  EXPECT_EQ(in.words.back().sightings.size(), 3U);
}

TEST(Delivery, GivesARobotsPerceptToItsAgentAlone) {
  const test::Run run;
  Participant world(run.world());
  Participant first(run.agent(1));
  Participant second(run.agent(2));
  Publisher<topics::Percept> out(world, {1});
  Inbox<topics::Percept> mine(first, {1});
  Inbox<topics::Percept> other(second, {2});
  ASSERT_TRUE(eventually([&] { return out.readers() == 1 && mine.subscriber.writers() == 1; }));
  Percept percept;
  percept.robot = {1};
  out.publish(percept);
  EXPECT_TRUE(mine.has(1));
  EXPECT_EQ(out.readers(), 1);
  EXPECT_TRUE(other.mailbox.collect().empty());
}

TEST(Delivery, GivesAConsoleThatComesLateTheWholeEventLog) {
  const test::Run run;
  Participant world(run.world());
  Publisher<topics::Events> out(world);
  constexpr std::uint64_t kBatches = 6000;  // More than any default limit.
  for (std::uint64_t i = 0; i < kBatches; ++i) ASSERT_TRUE(out.publish(batch(i)));

  Participant console(run.console());
  Inbox<topics::Events> in(console);
  ASSERT_TRUE(in.has(kBatches));
  for (std::uint64_t i = 0; i < kBatches; ++i) ASSERT_EQ(in.words[i].first, i);
  EXPECT_TRUE(out.wait_received(std::chrono::seconds(5)));
}

TEST(Delivery, GivesAConsoleThatCameBackTheWholeEventLog) {
  const test::Run run;
  Participant world(run.world());
  Publisher<topics::Events> out(world);
  {
    Participant console(run.console(1));
    Inbox<topics::Events> in(console);
    for (std::uint64_t i = 0; i < 10; ++i) out.publish(batch(i));
    ASSERT_TRUE(in.has(10));
  }
  out.publish(batch(10));
  Participant console(run.console(2));
  Inbox<topics::Events> in(console);
  ASSERT_TRUE(in.has(11));
  EXPECT_EQ(in.words.front().first, 0U);
}

TEST(Delivery, OfAnOrderReachesAnAgentThatComesLate) {
  const test::Run run;
  Participant world(run.world());
  Publisher<topics::Order> out(world, {1});
  out.publish({{1}, 7, OrderKind::Refuse, "because"});
  Participant agent(run.agent(1));
  Inbox<topics::Order> in(agent, {1});
  ASSERT_TRUE(in.has(1));
  EXPECT_EQ(in.words[0].reason, "because");
}

TEST(Delivery, OfAStatusGivesALateReaderTheNewest) {
  const test::Run run;
  Participant world(run.world());
  Publisher<topics::Status> out(world);
  RunStatus status;
  for (Tick tick = 0; tick < 50; ++tick) {
    status.tick = tick;
    out.publish(status);
  }
  Participant console(run.console());
  Inbox<topics::Status> in(console);
  ASSERT_TRUE(in.has(1));
  EXPECT_EQ(in.words[0].tick, 49U);
}

TEST(Delivery, OfATrajectoryHasNoGapsAlsoWhenViewsAreLarge) {
  const test::Run run;
  Participant world(run.world());
  Participant console(run.console());
  Publisher<topics::Trajectory> out(world);
  Inbox<topics::Trajectory> in(console);
  ASSERT_TRUE(eventually([&] { return out.readers() == 1 && in.subscriber.writers() == 1; }));
  WorldView view;
  view.robots.resize(WorldView::kMaxBodies, {{1}, {}, {}, true});
  view.enemies.resize(WorldView::kMaxBodies, {{1}, EnemyKind::Normal, {}});
  constexpr std::size_t kViews = 300;
  for (view.tick = 0; view.tick < kViews; ++view.tick) ASSERT_TRUE(out.publish(view));
  ASSERT_TRUE(in.has(kViews));
  for (std::size_t i = 0; i < kViews; ++i) ASSERT_EQ(in.words[i].tick, i);
}

TEST(Delivery, KeepsRunsApart) {
  const test::Run one;
  const test::Run two;
  Participant world_one(one.world());
  Participant world_two(two.world());
  Publisher<topics::Status> out_one(world_one);
  Publisher<topics::Status> out_two(world_two);
  Participant console(one.console());
  Inbox<topics::Status> in(console);
  out_one.publish({});
  ASSERT_TRUE(in.has(1));
  EXPECT_EQ(out_one.readers(), 1);
  EXPECT_EQ(out_two.readers(), 0);
}

TEST(Delivery, KeepsRunsOfOneDomainApartByTheirNonce) {
  const test::Run run;
  Participant world(run.world());
  Publisher<topics::Status> out(world);
  Identity stranger = run.console();
  stranger.run_nonce ^= 0xffff;
  Participant other(stranger);
  Inbox<topics::Status> deaf(other);
  Participant console(run.console());
  Inbox<topics::Status> in(console);
  out.publish({});
  ASSERT_TRUE(in.has(1));
  EXPECT_EQ(out.readers(), 1);
  EXPECT_EQ(deaf.subscriber.writers(), 0);
}

TEST(Delivery, NoticesThatAnAgentLeft) {
  const test::Run run;
  Participant world(run.world());
  Publisher<topics::Percept> out(world, {1});
  {
    Participant agent(run.agent(1));
    Inbox<topics::Percept> in(agent, {1});
    ASSERT_TRUE(eventually([&] { return out.readers() == 1; }));
  }
  EXPECT_TRUE(eventually([&] { return out.readers() == 0; }));
}

TEST(Participant, LeavesNothingInSharedMemory) {
  const test::Run run;
  {
    Participant world(run.world());
    Participant agent(run.agent(1));
    Publisher<topics::Percept> out(world, {1});
    Inbox<topics::Percept> in(agent, {1});
    ASSERT_TRUE(eventually([&] { return out.readers() == 1; }));
  }
  EXPECT_TRUE(leftovers(run.nonce()).empty());
}

}  // namespace
}  // namespace tacit
