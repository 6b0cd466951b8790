#include "console/report/decay_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "console/report/estimate.h"
#include "console/report/exponential.h"
#include "idl/types/elementary.h"

namespace tacit {
namespace {

constexpr double kStraight = 0.01;  ///< b times the span of x: hardly bent.
constexpr double kStep = 20.0;      ///< b times the smallest gap of x: hardly there at the second.
constexpr double kGridRatio = 1.1;
constexpr int kSections = 40;

struct Point {
  double x;
  double y;
  double weight;
};

/// A straight line in some function of x, and what it leaves over.
struct LineFit {
  double slope = 0.0;
  double level = 0.0;
  double squares = 0.0;
};

template <class Function>
LineFit fit_line(const std::vector<Point>& points, const Function& function) {
  std::vector<double> f;
  double weight = 0.0;
  double mean_f = 0.0;
  double mean_y = 0.0;
  for (const Point& p : points) {
    f.push_back(function(p.x));
    weight += p.weight;
    mean_f += p.weight * f.back();
    mean_y += p.weight * p.y;
  }
  mean_f /= weight;
  mean_y /= weight;
  double ff = 0.0;
  double fy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double to_f = f[i] - mean_f;
    const double to_y = points[i].y - mean_y;
    ff += points[i].weight * to_f * to_f;
    fy += points[i].weight * to_f * to_y;
    yy += points[i].weight * to_y * to_y;
  }
  const double slope = ff > 0.0 ? fy / ff : 0.0;
  return {slope, mean_y - slope * mean_f, std::max(0.0, yy - slope * fy)};
}

double mean_of(const FitCell& cell) { return *mean(cell.values); }

/// The cells' means without what sets the blocks apart.
std::vector<Point> centred(std::span<const FitCell> cells) {
  std::map<std::size_t, std::vector<double>> by_block;
  std::vector<double> all;
  for (const FitCell& cell : cells) {
    by_block[cell.block].push_back(mean_of(cell));
    all.push_back(mean_of(cell));
  }
  const double overall = mean(all).value_or(0.0);
  std::map<std::size_t, double> levels;
  for (const auto& [block, values] : by_block) {
    levels[block] = *mean(values) - overall;
  }
  std::vector<Point> points;
  for (const FitCell& cell : cells) {
    points.push_back({cell.x, mean_of(cell) - levels[cell.block], 1.0});
  }
  return points;
}

/// One point for each x; a curve that is best for these is best for all.
std::vector<Point> averaged(const std::vector<Point>& points) {
  std::map<double, Point> by_x;
  for (const Point& p : points) {
    Point& sum = by_x.try_emplace(p.x, Point{p.x, 0.0, 0.0}).first->second;
    sum.y += p.y;
    sum.weight += 1.0;
  }
  std::vector<Point> means;
  for (const auto& [x, sum] : by_x) {
    means.push_back({x, sum.y / sum.weight, sum.weight});
  }
  return means;
}

/// The best decay for a given b. Its exponential is 1 at the smallest x, so that no a overflows.
LineFit fit_bend(const std::vector<Point>& means, double b) {
  const double start = means.front().x;
  return fit_line(means, [b, start](double x) { return exponential(-b * (x - start)); });
}

double smallest_gap(const std::vector<Point>& means) {
  double gap = means[1].x - means[0].x;
  for (std::size_t i = 2; i < means.size(); ++i) {
    gap = std::min(gap, means[i].x - means[i - 1].x);
  }
  return gap;
}

double best_on_grid(const std::vector<Point>& means) {
  const double last = kStep / smallest_gap(means);
  double best = kStraight / (means.back().x - means.front().x);
  double least = fit_bend(means, best).squares;
  for (double b = best * kGridRatio; b <= last; b *= kGridRatio) {
    const double squares = fit_bend(means, b).squares;
    if (squares < least) {
      least = squares;
      best = b;
    }
  }
  return best;
}

double refined(const std::vector<Point>& means, double near) {
  const double golden = (std::sqrt(5.0) - 1.0) / 2.0;
  double low = near / kGridRatio;
  double high = near * kGridRatio;
  for (int i = 0; i < kSections; ++i) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    const bool lower_half = fit_bend(means, left).squares < fit_bend(means, right).squares;
    (lower_half ? high : low) = lower_half ? right : left;
  }
  return (low + high) / 2.0;
}

/// `means` at four or more x, rising.
Decay best_decay(const std::vector<Point>& means) {
  const double b = refined(means, best_on_grid(means));
  const LineFit line = fit_bend(means, b);
  return {line.slope * exponential(b * means.front().x), b, line.level};
}

double squares_left(const std::vector<Point>& points, const Decay& curve) {
  double squares = 0.0;
  for (const Point& p : points) {
    squares += (p.y - curve.at(p.x)) * (p.y - curve.at(p.x));
  }
  return squares;
}

double akaike(double squares, std::size_t points, std::size_t parameters) {
  constexpr double kPerfect = 1e-300;
  const auto n = static_cast<double>(points);
  return n * natural_log(std::max(squares / n, kPerfect)) + 2.0 * static_cast<double>(parameters);
}

std::size_t blocks_in(std::span<const FitCell> cells) {
  std::set<std::size_t> blocks;
  for (const FitCell& cell : cells) {
    blocks.insert(cell.block);
  }
  return blocks.size();
}

}  // namespace

double Decay::at(double x) const { return a * exponential(-b * x) + c; }

std::optional<DecayFit> fit_decay(std::span<const FitCell> cells) {
  const std::vector<Point> points = centred(cells);
  const std::vector<Point> means = averaged(points);
  const double total = fit_line(points, [](double) { return 0.0; }).squares;
  if (means.size() < 4 || total <= 0.0) {
    return std::nullopt;
  }
  const Decay curve = best_decay(means);
  const double left = squares_left(points, curve);
  const double line = fit_line(points, [](double x) { return x; }).squares;
  // The blocks' levels and the variance; the level of the first block is the model's constant.
  const std::size_t common = blocks_in(cells);
  return DecayFit{curve, 1.0 - left / total, akaike(left, points.size(), common + 3),
                  akaike(line, points.size(), common + 2),
                  akaike(total, points.size(), common + 1)};
}

std::optional<Decay> decay_curve(std::span<const FitCell> cells) {
  const std::vector<Point> means = averaged(centred(cells));
  return means.size() < 4 ? std::nullopt : std::optional(best_decay(means));
}

}  // namespace tacit
