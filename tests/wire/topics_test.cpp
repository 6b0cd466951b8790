#include <gtest/gtest.h>

#include <set>

#include "idl/topics/topics.h"

namespace tacit {
namespace {

TEST(Topics, HaveDifferentNames) {
  std::set<std::string> names;
  int count = 0;
  for_each_topic([&](auto topic) {
    names.insert(topic_name<decltype(topic)>({3}));
    ++count;
  });
  EXPECT_EQ(static_cast<int>(names.size()), count);
}

TEST(Topics, LeadFromNoAgentToAnAgent) {
  for_each_topic([](auto topic) {
    using Topic = decltype(topic);
    EXPECT_FALSE(Topic::kWriters.contains(Party::Agent) && Topic::kReaders.contains(Party::Agent))
        << Topic::kName;
  });
}

TEST(Topics, TellAnAgentOnlyWhatTheWorldServerWrites) {
  for_each_topic([](auto topic) {
    using Topic = decltype(topic);
    if (!Topic::kReaders.contains(Party::Agent)) return;
    EXPECT_EQ(Topic::kWriters.bits, Parties(Party::World).bits) << Topic::kName;
    EXPECT_EQ(Topic::kScope, Scope::Robot) << Topic::kName;
  });
}

TEST(Topics, OfARobotCarryItsNumber) {
  EXPECT_EQ(topic_name<topics::Percept>({12}), "tacit/robot_12/percept");
  EXPECT_EQ(topic_name<topics::Events>(), "tacit/events");
}

TEST(Topics, AreListedForEachKindOfProcess) {
  EXPECT_EQ(interface_text(Party::Launcher),
            "reads   tacit/status                latest state\n"
            "writes  tacit/control               must arrive\n");
}

}  // namespace
}  // namespace tacit
