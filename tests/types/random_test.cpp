#include "idl/types/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace tacit {
namespace {

constexpr int kMany = 100000;

std::vector<std::uint64_t> draws(Stream stream, int count) {
  std::vector<std::uint64_t> out;
  for (int i = 0; i < count; ++i) {
    out.push_back(stream.bits());
  }
  return out;
}

// The known answers that Random123 publishes for philox4x32-10.
TEST(Philox, GivesTheKnownAnswerToZero) {
  EXPECT_EQ(philox({0, 0, 0, 0}, 0), (PhiloxBlock{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(Philox, GivesTheKnownAnswerToAllOnes) {
  constexpr std::uint32_t kOnes = 0xffffffff;
  EXPECT_EQ(philox({kOnes, kOnes, kOnes, kOnes}, 0xffffffffffffffff),
            (PhiloxBlock{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
}

TEST(Philox, GivesTheKnownAnswerToTheDigitsOfPi) {
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822),
            (PhiloxBlock{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Streams, GiveTheSameDrawsForTheSameName) {
  EXPECT_EQ(draws(Stream(7, "wander", 3), 100), draws(Stream(7, "wander", 3), 100));
}

TEST(Streams, PartBySeedPurposeAndOwner) {
  std::set<std::uint64_t> firsts;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32}) {
    for (const char* purpose : {"", "a", "b", "ab", "ba"}) {
      for (const std::uint64_t owner :
           {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32}) {
        firsts.insert(Stream(seed, purpose, owner).bits());
      }
    }
  }
  EXPECT_EQ(firsts.size(), 3u * 5u * 3u);
}

TEST(Streams, DoNotDisturbOneAnother) {
  Stream one(7, "one");
  Stream other(7, "other");
  std::vector<std::uint64_t> interleaved;
  for (int i = 0; i < 100; ++i) {
    interleaved.push_back(one.bits());
    for (int extra = 0; extra < i % 3; ++extra) {
      static_cast<void>(other.normal());
    }
  }
  EXPECT_EQ(interleaved, draws(Stream(7, "one"), 100));
}

TEST(Streams, ContinueFromAPosition) {
  Stream first(7, "wander");
  for (int i = 0; i < 41; ++i) {
    static_cast<void>(first.uniform());
  }
  Stream second(7, "wander");
  second.seek(first.position());
  EXPECT_EQ(draws(second, 50), draws(first, 50));
}

TEST(Streams, AnswerAlikeHoweverFarTheyAreMoved) {
  Stream stream(7, "wander");
  const std::uint64_t far = (std::uint64_t{1} << 40) + 5;
  stream.seek(far);
  const std::uint64_t there = stream.bits();
  stream.seek(3);
  static_cast<void>(stream.bits());
  stream.seek(far);
  EXPECT_EQ(stream.bits(), there);
  EXPECT_EQ(stream.position(), far + 1);
}

TEST(Streams, RepeatNoDraw) {
  const std::vector<std::uint64_t> all = draws(Stream(7, "wander"), 20000);
  EXPECT_EQ(std::set<std::uint64_t>(all.begin(), all.end()).size(), all.size());
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
  double third = 0.0;   // standardised
  double fourth = 0.0;  // standardised
};

template <class Draw>
Moments moments(Draw draw) {
  std::vector<double> all;
  Moments m;
  for (int i = 0; i < kMany; ++i) {
    all.push_back(draw());
    m.mean += all.back() / kMany;
  }
  for (const double x : all) {
    m.variance += (x - m.mean) * (x - m.mean) / kMany;
  }
  for (const double x : all) {
    const double z = (x - m.mean) / std::sqrt(m.variance);
    m.third += z * z * z / kMany;
    m.fourth += z * z * z * z / kMany;
  }
  return m;
}

// Bounds of the moments are five standard errors wide.
TEST(UniformDraws, StayInTheHalfOpenUnitInterval) {
  Stream stream(8, "uniform");
  for (int i = 0; i < kMany; ++i) {
    const double x = stream.uniform();
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
  }
}

TEST(UniformDraws, HaveMeanOneHalfAndVarianceOneTwelfth) {
  Stream stream(9, "uniform");
  const Moments m = moments([&stream] { return stream.uniform(); });
  EXPECT_NEAR(m.mean, 0.5, 0.0046);
  EXPECT_NEAR(m.variance, 1.0 / 12.0, 0.0012);
}

TEST(UniformDraws, FillTheIntervalAskedForAndNoMore) {
  Stream stream(10, "uniform");
  double least = 10.0;
  double most = -10.0;
  for (int i = 0; i < kMany; ++i) {
    const double x = stream.uniform(-3.0, 2.0);
    least = std::min(least, x);
    most = std::max(most, x);
  }
  EXPECT_GE(least, -3.0);
  EXPECT_LT(least, -2.99);
  EXPECT_LT(most, 2.0);
  EXPECT_GT(most, 1.99);
}

TEST(UniformDraws, AreNotRelatedToTheOneBefore) {
  Stream stream(11, "uniform");
  double before = stream.uniform() - 0.5;
  double covariance = 0.0;
  for (int i = 0; i < kMany; ++i) {
    const double now = stream.uniform() - 0.5;
    covariance += before * now / kMany;
    before = now;
  }
  EXPECT_NEAR(covariance * 12.0, 0.0, 0.016);
}

TEST(NormalDraws, HaveTheMomentsOfTheStandardNormal) {
  Stream stream(12, "normal");
  const Moments m = moments([&stream] { return stream.normal(); });
  EXPECT_NEAR(m.mean, 0.0, 0.016);
  EXPECT_NEAR(m.variance, 1.0, 0.023);
  EXPECT_NEAR(m.third, 0.0, 0.039);
  EXPECT_NEAR(m.fourth, 3.0, 0.078);
}

TEST(NormalDraws, AreNeverInfinite) {
  Stream stream(13, "normal");
  for (int i = 0; i < kMany; ++i) {
    ASSERT_TRUE(std::isfinite(stream.normal()));
  }
}

TEST(WholeDraws, ReachEveryNumberBelowTheCountEquallyOften) {
  Stream stream(14, "below");
  std::vector<int> seen(7, 0);
  for (int i = 0; i < kMany; ++i) {
    ++seen.at(stream.below(seen.size()));
  }
  const double expected = kMany / 7.0;
  double chi2 = 0.0;
  for (const int count : seen) {
    chi2 += (count - expected) * (count - expected) / expected;
  }
  // Six degrees of freedom: above 22.5 once in a thousand.
  EXPECT_LT(chi2, 22.5);
}

TEST(WholeDraws, OfOneAreZero) {
  Stream stream(15, "below");
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(stream.below(1), 0u);
  }
}

}  // namespace
}  // namespace tacit
