#pragma once

#include <string>
#include <vector>

#include "console/report/chart_axis.h"
#include "console/report/estimate.h"

namespace tacit {

/// A measured or computed y at an x. An interval that is not empty is drawn as well.
struct ChartPoint {
  double x = 0.0;
  Estimate y;
};

/// Points that belong together.
struct ChartSeries {
  enum class Style : unsigned char {
    Marks,  ///< Dots with error bars, joined by a dashed line.
    Curve,  ///< A solid line, its intervals as a band.
  };
  std::string name;  ///< In the legend.
  Style style = Style::Marks;
  std::vector<ChartPoint> points;  ///< x ascending.
};

/// Figures to be looked at.
struct Chart {
  std::string title;
  std::string x_title;
  std::string y_title;
  ChartAxis::Scale y_scale = ChartAxis::Scale::Linear;
  std::vector<ChartSeries> series;
};

/// Logarithmic when all of the points' values are above 0 and the largest is more than 20 times
/// the smallest.
[[nodiscard]] ChartAxis::Scale fitting_scale(const std::vector<ChartSeries>& series);

/// The chart as a picture (SVG 1.1) of 760 by 480 pixels, with axes, ticks, labels and a legend.
/// Each dot is a <circle>. A chart without points has axes only.
[[nodiscard]] std::string to_svg(const Chart& chart);

}  // namespace tacit
