#include "idl/bus/cdr.h"

#include <gtest/gtest.h>

#include "tests/wire/words.h"

namespace tacit {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class Word>
Bytes bytes_of(const Word& word) {
  Bytes bytes;
  to_cdr(word, bytes);
  return bytes;
}

/// Words and the bytes of what the bytes say are compared, so that lists and texts are as well.
template <class Word>
void expect_the_word_back(const Word& word) {
  const Bytes bytes = bytes_of(word);
  Word read;
  ASSERT_FALSE(from_cdr(bytes, read));
  EXPECT_EQ(bytes_of(read), bytes);
}

template <class Word>
void expect_every_cut_refused(const Word& word) {
  const Bytes bytes = bytes_of(word);
  Word read;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_TRUE(from_cdr({bytes.data(), size}, read)) << size << " of " << bytes.size();
  }
}

TEST(Cdr, GivesEachWordBack) {
  test::Words words(11);
  for (int i = 0; i < 100; ++i) {
    expect_the_word_back(words.batch());
    expect_the_word_back(words.status());
    expect_the_word_back(words.telemetry());
    expect_the_word_back(words.view());
  }
}

TEST(Cdr, RefusesBytesThatEndTooEarly) {
  test::Words words(12);
  expect_every_cut_refused(words.status());
  expect_every_cut_refused(words.telemetry());
  EventBatch batch;
  batch.events = {{1, EnemyCreated{{3}, EnemyKind::Normal, {}}}, {2, RunEnded{4}}};
  expect_every_cut_refused(batch);
  WorldView view;
  view.robots.resize(2);
  view.robots[0].robot = {1};
  view.robots[1].robot = {2};
  expect_every_cut_refused(view);
}

TEST(Cdr, RefusesAListLongerThanItsBytes) {
  WorldView view;
  view.robots.resize(1);
  view.robots[0].robot = {1};
  Bytes bytes = bytes_of(view);
  bytes[4 + 16] = 0xff;  // the count of robots, behind time and tick
  bytes[4 + 17] = 0xff;
  bytes[4 + 18] = 0xff;
  bytes[4 + 19] = 0x7f;
  WorldView read;
  EXPECT_TRUE(from_cdr(bytes, read));
}

}  // namespace
}  // namespace tacit
