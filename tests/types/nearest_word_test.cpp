#include "idl/types/nearest_word.h"

#include <gtest/gtest.h>

#include <vector>

namespace tacit {
namespace {

const std::vector<std::string> kWords{"guard", "crowd", "guard_figures"};

TEST(NearestWord, FindsAWordWithALetterMissing) {
  EXPECT_EQ(nearest_word("gard", kWords), "guard");
}

TEST(NearestWord, FindsAWordWithTwoLettersSwapped) {
  EXPECT_EQ(nearest_word("gaurd", kWords), "guard");
}

TEST(NearestWord, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest_word("escort", kWords), std::nullopt);
}

TEST(NearestWord, IsSilentWhenEveryLetterIsWrong) {
  const std::vector<std::string> two{"ab"};
  EXPECT_EQ(nearest_word("cd", two), std::nullopt);
}

TEST(DidYouMean, AsksOrSaysNothing) {
  EXPECT_EQ(did_you_mean("crwd", kWords), ", did you mean \"crowd\"?");
  EXPECT_EQ(did_you_mean("escort", kWords), "");
}

}  // namespace
}  // namespace tacit
