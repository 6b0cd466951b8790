#include "console/report/chart.h"

#include <gtest/gtest.h>

#include <vector>

namespace tacit {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// Whether every element that is opened is closed, in order, and quotes come in pairs.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) {
      return false;
    }
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos || count(tag, "\"") % 2 != 0) {
      return false;
    }
    const std::string name = tag.substr(0, tag.find(' '));
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) {
        return false;
      }
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  return open.empty();
}

Chart a_chart() {
  Chart chart{"Score <of> \"two\" & more", "robots", "ticks", ChartAxis::Scale::Linear, {}};
  chart.series.push_back({"measured",
                          ChartSeries::Style::Marks,
                          {{2, {90, 80, 100}}, {4, {50, 45, 55}}, {6, {40, 40, 40}}}});
  chart.series.push_back(
      {"fit", ChartSeries::Style::Curve, {{2, {88, 70, 110}}, {6, {41, 30, 50}}}});
  return chart;
}

TEST(Chart, IsWellFormedWhateverItsWords) {
  EXPECT_TRUE(is_well_formed(to_svg(a_chart())));
  EXPECT_NE(to_svg(a_chart()).find("Score &lt;of&gt; &quot;two&quot; &amp; more"),
            std::string::npos);
}

TEST(Chart, HasADotForEveryMeasuredPoint) { EXPECT_EQ(count(to_svg(a_chart()), "<circle"), 3U); }

TEST(Chart, HasABandForEveryCurve) { EXPECT_EQ(count(to_svg(a_chart()), "<polygon"), 1U); }

TEST(Chart, HasNoErrorBarForAnEmptyInterval) {
  Chart chart = a_chart();
  const std::size_t lines = count(to_svg(chart), "<line");
  chart.series[0].points[2].y = {40, 39, 41};
  EXPECT_EQ(count(to_svg(chart), "<line"), lines + 3);
}

TEST(Chart, NamesAxesAndSeries) {
  const std::string svg = to_svg(a_chart());
  for (const char* name : {">robots<", ">ticks<", ">measured<", ">fit<"}) {
    EXPECT_NE(svg.find(name), std::string::npos) << name;
  }
}

TEST(Chart, WithoutPointsIsWellFormed) {
  EXPECT_TRUE(is_well_formed(to_svg(Chart{})));
  Chart chart;
  chart.y_scale = ChartAxis::Scale::Logarithmic;
  EXPECT_TRUE(is_well_formed(to_svg(chart)));
}

TEST(Chart, IsLogarithmicWhereValuesSpanMuch) {
  Chart chart = a_chart();
  EXPECT_EQ(fitting_scale(chart.series), ChartAxis::Scale::Linear);
  chart.series[0].points[0].y.value = 4000;
  EXPECT_EQ(fitting_scale(chart.series), ChartAxis::Scale::Logarithmic);
  chart.series[0].points[2].y.value = 0;
  EXPECT_EQ(fitting_scale(chart.series), ChartAxis::Scale::Linear);
}

TEST(ChartAxis, RoundsOutwardToTicks) {
  const ChartAxis axis(ChartAxis::Scale::Linear, 3.0, 97.0);
  EXPECT_EQ(axis.ticks().front().label, "0");
  EXPECT_EQ(axis.ticks().back().label, "100");
  EXPECT_DOUBLE_EQ(axis.share(25.0), 0.25);
}

TEST(ChartAxis, SpacesPowersOfTenEvenly) {
  const ChartAxis axis(ChartAxis::Scale::Logarithmic, 100.0, 9000.0);
  EXPECT_EQ(axis.ticks().front().label, "100");
  EXPECT_EQ(axis.ticks().back().label, "10,000");
  EXPECT_NEAR(axis.share(1000.0), 0.5, 1e-12);
}

TEST(ChartAxis, TakesARangeOfOneValue) {
  for (const auto scale : {ChartAxis::Scale::Linear, ChartAxis::Scale::Logarithmic}) {
    const ChartAxis axis(scale, 100.0, 100.0);
    EXPECT_GE(axis.ticks().size(), 2U);
    EXPECT_LE(axis.share(100.0), 1.0);
  }
}

TEST(AxisLabel, PartsThousandsAndKeepsNeededDecimals) {
  EXPECT_EQ(axis_label(1234567.0, 1.0), "1,234,567");
  EXPECT_EQ(axis_label(-1000.0, 500.0), "-1,000");
  EXPECT_EQ(axis_label(0.25, 0.05), "0.25");
}

}  // namespace
}  // namespace tacit
