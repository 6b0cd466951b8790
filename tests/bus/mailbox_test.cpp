#include "idl/bus/mailbox.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace tacit {
namespace {

using Words = std::vector<std::string>;

Words collected(Mailbox<std::string>& mailbox) {
  const auto words = mailbox.collect();
  return {words.begin(), words.end()};
}

void put(Mailbox<std::string>& mailbox, std::string word) { mailbox.put(word); }

TEST(Mailbox, GivesWordsInTheOrderInWhichTheyCame) {
  Bell bell;
  Mailbox<std::string> mailbox(bell);
  put(mailbox, "a");
  put(mailbox, "b");
  EXPECT_EQ(collected(mailbox), (Words{"a", "b"}));
}

TEST(Mailbox, GivesEachWordOnce) {
  Bell bell;
  Mailbox<std::string> mailbox(bell);
  put(mailbox, "a");
  EXPECT_EQ(collected(mailbox), Words{"a"});
  EXPECT_EQ(collected(mailbox), Words{});
  put(mailbox, "b");
  EXPECT_EQ(collected(mailbox), Words{"b"});
}

TEST(Mailbox, RingsForAWord) {
  Bell bell;
  Mailbox<std::string> mailbox(bell);
  put(mailbox, "a");
  EXPECT_TRUE(bell.wait_until(Bell::Clock::now()));
}

TEST(Mailbox, LosesNothingBetweenTwoThreads) {
  Bell bell;
  Mailbox<std::string> mailbox(bell);
  constexpr int kWords = 20000;
  std::thread sender([&] {
    for (int i = 0; i < kWords; ++i) put(mailbox, std::to_string(i));
  });
  int next = 0;
  while (next < kWords) {
    bell.wait();
    for (const std::string& word : mailbox.collect()) ASSERT_EQ(word, std::to_string(next++));
  }
  sender.join();
}

}  // namespace
}  // namespace tacit
