#include "console/gateway/outbox.h"

#include <gtest/gtest.h>

namespace tacit::gateway {
namespace {

Frame message(const std::string& text) {
  return shared_frame(std::make_shared<const std::vector<std::uint8_t>>(text.begin(), text.end()));
}

std::string take(Outbox& outbox) {
  const auto frame = outbox.pop();
  return frame ? std::string(frame->body.begin(), frame->body.end()) : "nothing";
}

std::string take(Outbox& outbox, int count) {
  std::string all;
  for (; count > 0; --count) {
    all += take(outbox);
  }
  return all;
}

Limits small() {
  Limits limits;
  limits.queue_latest = 2;
  limits.queue_all = 4;
  limits.queue_bytes = 100;
  limits.control_bytes = 10;
  return limits;
}

TEST(Outbox, GivesMessagesInTheOrderTheyCame) {
  Outbox outbox(small());
  outbox.push_message(1, Keep::All, message("a"));
  outbox.push_message(2, Keep::Latest, message("b"));
  outbox.push_message(1, Keep::All, message("c"));
  EXPECT_EQ(take(outbox, 3), "abc");
  EXPECT_EQ(take(outbox), "nothing");
  EXPECT_EQ(outbox.bytes(), 0U);
}

TEST(Outbox, DropsTheOldestOfTheSameChannel) {
  Outbox outbox(small());
  outbox.push_message(2, Keep::All, message("x"));
  EXPECT_EQ(outbox.push_message(1, Keep::Latest, message("a")), 0U);
  EXPECT_EQ(outbox.push_message(1, Keep::Latest, message("b")), 0U);
  EXPECT_EQ(outbox.push_message(1, Keep::Latest, message("c")), 1U);
  EXPECT_EQ(take(outbox, 3), "xbc");
}

TEST(Outbox, HoldsNoMoreBytesThanItMay) {
  Outbox outbox(small());
  outbox.push_message(1, Keep::All, message(std::string(40, 'a')));
  outbox.push_message(2, Keep::All, message(std::string(40, 'b')));
  EXPECT_EQ(outbox.push_message(2, Keep::All, message(std::string(40, 'c'))), 1U);
  EXPECT_EQ(outbox.push_message(3, Keep::All, message(std::string(90, 'd'))), 2U);
  EXPECT_EQ(outbox.bytes(), 90U);
  EXPECT_EQ(take(outbox), std::string(90, 'd'));
}

TEST(Outbox, SendsAMessageThatIsLargerThanAllItMayHold) {
  Outbox outbox(small());
  outbox.push_message(1, Keep::All, message("a"));
  EXPECT_EQ(outbox.push_message(1, Keep::All, message(std::string(200, 'b'))), 1U);
  EXPECT_EQ(take(outbox), std::string(200, 'b'));
}

TEST(Outbox, PutsControlFirstAndDropsNoneOfIt) {
  Outbox outbox(small());
  outbox.push_message(1, Keep::All, message("telemetry"));
  outbox.set_time(message("early"));
  outbox.set_time(message("time"));
  for (const std::string text : {"one", "two", "three"}) {
    outbox.push(text_frame(text));
  }
  EXPECT_TRUE(outbox.is_overfull());
  EXPECT_EQ(take(outbox, 3), "onetwothree");
  EXPECT_FALSE(outbox.is_overfull());
  EXPECT_EQ(take(outbox), "time");
  EXPECT_EQ(take(outbox), "telemetry");
}

TEST(Outbox, ForgetsAChannel) {
  Outbox outbox(small());
  outbox.push_message(1, Keep::All, message("a"));
  outbox.push_message(2, Keep::All, message("b"));
  outbox.push_message(1, Keep::All, message("c"));
  outbox.forget(1);
  EXPECT_EQ(take(outbox), "b");
  EXPECT_EQ(take(outbox), "nothing");
}

}  // namespace
}  // namespace tacit::gateway
