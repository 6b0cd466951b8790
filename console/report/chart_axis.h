#pragma once

#include <string>
#include <vector>

namespace tacit {

/// A place on an axis that is marked and named.
struct AxisTick {
  double value = 0.0;
  std::string label;
};

/// An axis: values in a range, laid out over a length.
class ChartAxis {
 public:
  enum class Scale : unsigned char { Linear, Logarithmic };

  /// Spans `low` to `high`, rounded outward to ticks. An empty range is widened; a logarithmic
  /// axis needs `low` > 0.
  ChartAxis(Scale scale, double low, double high);

  /// Where `value` lies: 0 at the low end, 1 at the high end.
  [[nodiscard]] double share(double value) const;
  /// Ascending; both ends have one.
  [[nodiscard]] const std::vector<AxisTick>& ticks() const { return ticks_; }

 private:
  void mark_linear(double low, double high);
  void mark_logarithmic(double low, double high);

  Scale scale_;
  std::vector<AxisTick> ticks_;
};

/// "1,234.5": as few decimals as `step` needs, thousands apart.
[[nodiscard]] std::string axis_label(double value, double step);

}  // namespace tacit
