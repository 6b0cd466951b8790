#include "console/metrics/idle_spread.h"

#include <cmath>
#include <span>

namespace tacit {
namespace {

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

}  // namespace

void IdleSpread::add(const Event& event) {
  const auto* checkpoint = std::get_if<Checkpoint>(&event.what);
  if (checkpoint != nullptr && checkpoint->enemies == 0) {
    distance_m_.push_back(checkpoint->mean_distance_to_target_m);
    speed_mps_.push_back(checkpoint->mean_speed_mps);
  }
}

std::optional<double> IdleSpread::mean_distance_m() const {
  if (distance_m_.empty()) {
    return std::nullopt;
  }
  return mean_of(std::span(distance_m_).subspan(settled()));
}

std::optional<double> IdleSpread::sd_distance_m() const {
  const auto distances = std::span(distance_m_).subspan(settled());
  if (distances.size() < 2) {
    return std::nullopt;
  }
  const double mean = mean_of(distances);
  double squares = 0.0;
  for (const double distance : distances) {
    squares += (distance - mean) * (distance - mean);
  }
  return std::sqrt(squares / static_cast<double>(distances.size() - 1));
}

std::optional<double> IdleSpread::mean_speed_mps() const {
  if (speed_mps_.empty()) {
    return std::nullopt;
  }
  return mean_of(std::span(speed_mps_).subspan(settled()));
}

std::vector<Metric> IdleSpread::metrics() const {
  return {{"idle_mean_distance_m", "m",
           "Mean distance of the robots to the target once settled, while there are no enemies.",
           measured(mean_distance_m())},
          {"idle_sd_distance_m", "m", "Standard deviation over time of that distance.",
           measured(sd_distance_m())},
          {"idle_mean_speed_mps", "m/s", "Mean speed of the robots in that time.",
           measured(mean_speed_mps())}};
}

}  // namespace tacit
