#include "idl/cdl/value.h"

#include <gtest/gtest.h>

namespace tacit::cdl {
namespace {

using Numbers = std::vector<double>;

TEST(Values, AreTypedWhereTheTextShowsIt) {
  EXPECT_EQ(parse_value(" 2.5 "), Value(2.5));
  EXPECT_EQ(parse_value("-1"), Value(-1.0));
  EXPECT_EQ(parse_value("10, 20.5"), Value(Numbers{10.0, 20.5}));
  EXPECT_EQ(parse_value("6,1,10"), Value(Numbers{6.0, 1.0, 10.0}));
  EXPECT_EQ(parse_value("false"), Value(false));
  EXPECT_EQ(parse_value("Mines | Robots"), Value(Words{{"Mines", "Robots"}}));
  EXPECT_EQ(parse_value("\"a, b\""), Value(QuotedText{"a, b"}));
  EXPECT_EQ(parse_value(""), Value(NoValue{}));
  EXPECT_EQ(parse_value("^"), Value(FromAbove{}));
  EXPECT_EQ(parse_value("^Range_01 %curious"), Value(FromAbove{"Range_01", "curious"}));
}

TEST(Values, TakeWhatIsNoNumberForAWord) {
  for (const char* text : {"inf", "nan", "1e999", "1 2", "0x10", "--1"}) {
    EXPECT_EQ(parse_value(text), Value(Words{{text}})) << text;
  }
}

}  // namespace
}  // namespace tacit::cdl
