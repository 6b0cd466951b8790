#include "world_server/world/contact_log.h"

#include <gtest/gtest.h>

#include <vector>

namespace tacit {
namespace {

constexpr Contact kFirst{0, ContactSide::Obstacle, 3};
constexpr Contact kSecond{1, ContactSide::Wall, 0};

std::vector<Contact> begun(ContactLog& log, const std::vector<Contact>& now, Tick tick) {
  const auto span = log.begun(now, tick);
  return {span.begin(), span.end()};
}

TEST(ContactLog, TellsANewContact) {
  ContactLog log;
  EXPECT_EQ(begun(log, {kFirst}, 5), (std::vector<Contact>{kFirst}));
}

TEST(ContactLog, IsSilentAboutALastingContact) {
  ContactLog log;
  begun(log, {kFirst}, 5);
  for (Tick tick = 6; tick < 100; ++tick) {
    ASSERT_TRUE(begun(log, {kFirst}, tick).empty());
  }
}

TEST(ContactLog, IsSilentWhenTheGapIsShorterThanThePause) {
  ContactLog log;
  begun(log, {kFirst}, 5);
  const Tick back = 5 + ContactLog::kApartTicks - 1;
  for (Tick tick = 6; tick < back; ++tick) {
    begun(log, {}, tick);
  }
  EXPECT_TRUE(begun(log, {kFirst}, back).empty());
}

TEST(ContactLog, TellsAContactAgainAfterThePause) {
  ContactLog log;
  begun(log, {kFirst}, 5);
  const Tick back = 5 + ContactLog::kApartTicks;
  for (Tick tick = 6; tick < back; ++tick) {
    begun(log, {}, tick);
  }
  EXPECT_EQ(begun(log, {kFirst}, back), (std::vector<Contact>{kFirst}));
}

TEST(ContactLog, MeasuresThePauseFromTheLastTouch) {
  ContactLog log;
  for (Tick tick = 0; tick < 100; tick += ContactLog::kApartTicks - 1) {
    EXPECT_EQ(begun(log, {kFirst}, tick).empty(), tick != 0);
  }
}

TEST(ContactLog, CountsEachPairByItself) {
  ContactLog log;
  begun(log, {kFirst}, 5);
  EXPECT_EQ(begun(log, {kFirst, kSecond}, 6), (std::vector<Contact>{kSecond}));
  EXPECT_TRUE(begun(log, {kSecond}, 7).empty());
}

TEST(ContactLog, KeepsTheOrder) {
  ContactLog log;
  const std::vector<Contact> all{
      {0, ContactSide::Mover, 1}, kFirst, kSecond, {4, ContactSide::Mover, 9}};
  EXPECT_EQ(begun(log, all, 1), all);
}

}  // namespace
}  // namespace tacit
