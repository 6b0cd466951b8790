#include "console/report/chart.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "console/report/svg.h"

namespace tacit {
namespace {

constexpr double kWidth = 760.0;
constexpr double kHeight = 480.0;
constexpr double kLeft = 90.0;
constexpr double kRight = 570.0;
constexpr double kTop = 40.0;
constexpr double kBottom = 420.0;
/// Told apart by people who see colours differently (Okabe & Ito 2008).
constexpr std::array<std::string_view, 8> kColours{"#000000", "#0072b2", "#d55e00", "#009e73",
                                                   "#cc79a7", "#56b4e9", "#e69f00", "#f0e442"};

std::string dot(SvgPlace at, const std::string& colour) {
  return "<circle cx=\"" + svg_number(at.x) + "\" cy=\"" + svg_number(at.y) +
         "\" r=\"3.50\" fill=\"" + colour + "\"/>\n";
}

std::string path(const std::vector<SvgPlace>& places, const std::string& colour,
                 std::string_view more) {
  return "<polyline points=\"" + svg_list(places) + "\" fill=\"none\" stroke=\"" + colour + "\" " +
         std::string(more) + "/>\n";
}

constexpr std::string_view kInk = "stroke=\"#333333\"";
constexpr std::string_view kGrid = "stroke=\"#dddddd\"";
constexpr std::string_view kMiddle = "text-anchor=\"middle\"";
constexpr std::string_view kToTheLeft = "text-anchor=\"end\"";

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return low > high; }
};

Extent extent_x(const std::vector<ChartSeries>& series) {
  Extent extent;
  for (const ChartSeries& each : series) {
    for (const ChartPoint& point : each.points) {
      extent.take(point.x);
    }
  }
  return extent.empty() ? Extent{0.0, 1.0} : extent;
}

Extent extent_y(const std::vector<ChartSeries>& series, ChartAxis::Scale scale) {
  Extent extent;
  const bool above_zero = scale == ChartAxis::Scale::Logarithmic;
  for (const ChartSeries& each : series) {
    for (const ChartPoint& point : each.points) {
      for (const double y : {point.y.value, point.y.low, point.y.high}) {
        if (!above_zero || y > 0.0) {
          extent.take(y);
        }
      }
    }
  }
  return extent.empty() ? Extent{1.0, 10.0} : extent;
}

/// The chart's own plane.
class Drawing {
 public:
  explicit Drawing(const Chart& chart)
      : chart_(chart),
        x_(axis(ChartAxis::Scale::Linear, extent_x(chart.series))),
        y_(axis(chart.y_scale, extent_y(chart.series, chart.y_scale))) {}

  [[nodiscard]] std::string text() const {
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + svg_number(kWidth) +
                      "\" height=\"" + svg_number(kHeight) +
                      "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    svg += axes() + titles();
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
      const std::string colour(kColours[i % kColours.size()]);
      svg += drawn(chart_.series[i], colour) + legend(i, colour);
    }
    return svg + "</svg>\n";
  }

 private:
  static ChartAxis axis(ChartAxis::Scale scale, const Extent& extent) {
    return {scale, extent.low, extent.high};
  }

  [[nodiscard]] SvgPlace at(double x, double y) const {
    return {kLeft + (kRight - kLeft) * x_.share(x), kBottom - (kBottom - kTop) * y_.share(y)};
  }

  [[nodiscard]] std::string axes() const {
    std::string svg;
    for (const AxisTick& tick : y_.ticks()) {
      const double y = kBottom - (kBottom - kTop) * y_.share(tick.value);
      svg += svg_line({kLeft - 5, y}, {kRight, y}, kGrid);
      svg += svg_text({kLeft - 8, y + 4}, tick.label, kToTheLeft);
    }
    for (const AxisTick& tick : x_.ticks()) {
      const double x = kLeft + (kRight - kLeft) * x_.share(tick.value);
      svg += svg_line({x, kBottom}, {x, kBottom + 5}, kInk);
      svg += svg_text({x, kBottom + 19}, tick.label, kMiddle);
    }
    return svg + svg_line({kLeft, kBottom}, {kRight, kBottom}, kInk) +
           svg_line({kLeft, kTop}, {kLeft, kBottom}, kInk);
  }

  [[nodiscard]] std::string titles() const {
    const double middle = (kTop + kBottom) / 2;
    const std::string turned =
        std::string(kMiddle) + " transform=\"rotate(-90 16 " + svg_number(middle) + ")\"";
    return svg_text({(kLeft + kRight) / 2, 22}, chart_.title,
                    "text-anchor=\"middle\" font-size=\"14\"") +
           svg_text({(kLeft + kRight) / 2, kHeight - 16}, chart_.x_title, kMiddle) +
           svg_text({16, middle}, chart_.y_title, turned);
  }

  [[nodiscard]] std::string drawn(const ChartSeries& series, const std::string& colour) const {
    std::vector<SvgPlace> places;
    for (const ChartPoint& point : series.points) {
      places.push_back(at(point.x, point.y.value));
    }
    if (series.style == ChartSeries::Style::Curve) {
      return band(series, colour) + path(places, colour, "stroke-width=\"2\"");
    }
    std::string svg = path(places, colour, "stroke-dasharray=\"5 4\"");
    for (std::size_t i = 0; i < places.size(); ++i) {
      svg += bar(series.points[i], colour) + dot(places[i], colour);
    }
    return svg;
  }

  [[nodiscard]] std::string bar(const ChartPoint& point, const std::string& colour) const {
    if (!(point.y.low < point.y.high)) {
      return "";
    }
    const SvgPlace low = at(point.x, point.y.low);
    const SvgPlace high = at(point.x, point.y.high);
    const std::string style = "stroke=\"" + colour + '"';
    return svg_line(low, high, style) + svg_line({low.x - 4, low.y}, {low.x + 4, low.y}, style) +
           svg_line({high.x - 4, high.y}, {high.x + 4, high.y}, style);
  }

  [[nodiscard]] std::string band(const ChartSeries& series, const std::string& colour) const {
    std::vector<SvgPlace> around;
    for (const ChartPoint& point : series.points) {
      around.push_back(at(point.x, point.y.high));
    }
    for (auto point = series.points.rbegin(); point != series.points.rend(); ++point) {
      around.push_back(at(point->x, point->y.low));
    }
    return "<polygon points=\"" + svg_list(around) + "\" fill=\"" + colour +
           "\" fill-opacity=\"0.15\"/>\n";
  }

  [[nodiscard]] std::string legend(std::size_t number, const std::string& colour) const {
    const ChartSeries& series = chart_.series[number];
    const double y = kTop + 10 + 20 * static_cast<double>(number);
    const bool curve = series.style == ChartSeries::Style::Curve;
    return path({{kRight + 16, y}, {kRight + 44, y}}, colour,
                curve ? "stroke-width=\"2\"" : "stroke-dasharray=\"5 4\"") +
           svg_text({kRight + 50, y + 4}, series.name, "text-anchor=\"start\"");
  }

  const Chart& chart_;
  ChartAxis x_;
  ChartAxis y_;
};

}  // namespace

ChartAxis::Scale fitting_scale(const std::vector<ChartSeries>& series) {
  constexpr double kWide = 20.0;
  Extent values;
  for (const ChartSeries& each : series) {
    for (const ChartPoint& point : each.points) {
      values.take(point.y.value);
    }
  }
  const bool wide = !values.empty() && values.low > 0.0 && values.high > kWide * values.low;
  return wide ? ChartAxis::Scale::Logarithmic : ChartAxis::Scale::Linear;
}

std::string to_svg(const Chart& chart) { return Drawing(chart).text(); }

}  // namespace tacit
