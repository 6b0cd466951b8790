#include "console/report/chart_axis.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "idl/types/elementary.h"

namespace tacit {
namespace {

constexpr double kIntervals = 6.0;
constexpr std::array<double, 3> kRound{1.0, 2.0, 5.0};

/// 10^exponent.
double power_of_ten(int exponent) {
  double power = 1.0;
  for (int i = 0; i < std::abs(exponent); ++i) {
    power *= 10.0;
  }
  return exponent < 0 ? 1.0 / power : power;
}

int exponent_of(double value) {
  return static_cast<int>(std::floor(natural_log(value) / natural_log(10.0) + 1e-12));
}

/// The smallest of 1, 2, 5, 10, 20, … (and their fractions) that is not below `wanted`.
double round_step(double wanted) {
  const double power = power_of_ten(exponent_of(wanted));
  for (const double round : kRound) {
    if (round * power >= wanted * (1.0 - 1e-9)) {
      return round * power;
    }
  }
  return 10.0 * power;
}

std::string thousands_apart(std::string digits) {
  const std::size_t start = digits.front() == '-' ? 1 : 0;
  std::size_t place = std::min(digits.find('.'), digits.size());
  while (place > start + 3) {
    place -= 3;
    digits.insert(place, 1, ',');
  }
  return digits;
}

}  // namespace

std::string axis_label(double value, double step) {
  const int decimals = step >= 1.0 ? 0 : -exponent_of(step);
  std::array<char, 400> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  return thousands_apart({digits.data(), end});
}

ChartAxis::ChartAxis(Scale scale, double low, double high) : scale_(scale) {
  if (scale == Scale::Logarithmic) {
    mark_logarithmic(low, high);
  } else {
    mark_linear(low, high > low ? high : low + 1.0);
  }
}

void ChartAxis::mark_linear(double low, double high) {
  const double step = round_step((high - low) / kIntervals);
  const double first = std::floor(low / step + 1e-9);
  const double last = std::ceil(high / step - 1e-9);
  for (double i = first; i <= last; i += 1.0) {
    ticks_.push_back({i * step, axis_label(i * step, step)});
  }
}

void ChartAxis::mark_logarithmic(double low, double high) {
  for (int exponent = exponent_of(low); ticks_.empty() || ticks_.back().value < high; ++exponent) {
    for (const double round : kRound) {
      const double value = round * power_of_ten(exponent);
      if (ticks_.size() == 1 && value <= low) {
        ticks_.clear();
      }
      if (ticks_.size() < 2 || ticks_.back().value < high) {
        ticks_.push_back({value, axis_label(value, value)});
      }
    }
  }
}

double ChartAxis::share(double value) const {
  const double low = ticks_.front().value;
  const double high = ticks_.back().value;
  if (scale_ == Scale::Logarithmic) {
    return natural_log(std::max(value, low) / low) / natural_log(high / low);
  }
  return (value - low) / (high - low);
}

}  // namespace tacit
