#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "idl/overlay/ground.h"

namespace tacit {

/// A drawing in letters, north on top, a letter twice as high as wide.
class TextCanvas {
 public:
  /// At most `columns` wide and `rows` high.
  TextCanvas(const MapSize& size, int columns, double rows = kMostRows)
      : cell_m_(std::max(size.width_m / columns, size.height_m / rows / 2.0)),
        columns_(count(size.width_m / cell_m_)),
        rows_(count(size.height_m / cell_m_ / 2.0)),
        lines_(static_cast<std::size_t>(rows_),
               std::string(static_cast<std::size_t>(columns_), ' ')) {}

  /// What lies outside is not drawn.
  void point(const MapPoint& p, char letter) {
    const double column = std::floor(p.x_m / cell_m_);
    const double row = std::floor(p.y_m / cell_m_ / 2.0);
    if (column < 0.0 || row < 0.0 || column > columns_ || row > rows_) return;
    const int x = std::min(static_cast<int>(column), columns_ - 1);
    const int y = std::min(static_cast<int>(row), rows_ - 1);
    lines_[static_cast<std::size_t>(rows_ - 1 - y)][static_cast<std::size_t>(x)] = letter;
  }

  void line(const MapPoint& from, const MapPoint& to, char letter) {
    const double steps = std::clamp(2.0 * length_m({from, to}) / cell_m_, 1.0, kMostSteps);
    for (double i = 0.0; i <= steps; i += 1.0) {
      const double share = i / steps;
      point({from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)},
            letter);
    }
  }

  void disc(const MapPoint& centre, double radius_m, char letter) {
    const double step = std::max(cell_m_ / 2.0, radius_m / 500.0);
    for (double dx = -radius_m; dx <= radius_m; dx += step) {
      const double dy = std::sqrt(std::max(0.0, radius_m * radius_m - dx * dx));
      line({centre.x_m + dx, centre.y_m - dy}, {centre.x_m + dx, centre.y_m + dy}, letter);
    }
    point(centre, letter);
  }

  /// With a border.
  [[nodiscard]] std::string text() const {
    const std::string border = '+' + std::string(static_cast<std::size_t>(columns_), '-') + "+\n";
    std::string all = border;
    for (const std::string& one : lines_) all += '|' + one + "|\n";
    return all + border;
  }

 private:
  static constexpr double kMostRows = 200.0;
  static constexpr double kMostSteps = 2000.0;

  static int count(double cells) { return std::max(1, static_cast<int>(std::ceil(cells - 1e-9))); }

  double cell_m_;
  int columns_;
  int rows_;
  std::vector<std::string> lines_;
};

}  // namespace tacit
