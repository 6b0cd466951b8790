#include "robot_agent/brain/learning/robot_momentum.h"

#include <algorithm>
#include <cmath>

namespace tacit {
namespace {

struct Span {
  double low;
  double high;
};

/// The steps that one situation allows.
struct Steps {
  Span goal;
  Span obstacle;
  Span noise;
  Span sphere_m;
  Span persistence;
};

// MissionLab's, in the order of Situation.
constexpr std::array<Steps, 4> kSteps{{
    {{-0.1, 0.0}, {-0.1, 0.0}, {0.1, 0.5}, {-0.5, 0.0}, {0, 1}},
    {{0.5, 1.0}, {-0.1, 0.0}, {-0.1, 0.0}, {-0.5, 0.0}, {-1, 0}},
    {{-0.1, 0.0}, {0.1, 0.5}, {0.0, 0.5}, {0.0, 0.5}, {0, 1}},
    {{0.0, 0.3}, {-0.1, 0.0}, {-0.2, 0.0}, {0.0, 0.5}, {-1, 0}},
}};

constexpr Span kGoal{0.5, 2.0};
constexpr Span kNoise{0.01, 5.0};
constexpr double kMostObstacle = 5.0;
constexpr Span kSphereM{0.1, 5.0};
constexpr Span kPersistence{1, 15};

constexpr double kStandingM = 0.02;
constexpr double kProgressRatio = 0.025;
constexpr double kManyObstacles = 1.5;

double within(double value, const Span& span) { return std::clamp(value, span.low, span.high); }

}  // namespace

bool RobotMomentum::note(const Sample& sample) {
  window_[samples_++ % kWindow] = sample;
  if (samples_ < kWindow || samples_ % kInterval != 0) return false;
  adjust(situation());
  return true;
}

RobotMomentum::Situation RobotMomentum::situation() const {
  double moved_m = 0.0;
  double obstacles = 0.0;
  for (const Sample& each : window_) {
    moved_m += each.moved_m / kWindow;
    obstacles += each.obstacles / kWindow;
  }
  if (moved_m < kStandingM) return Situation::NoMovement;
  // Four successive decreases add up to what lies between the first and the last sample.
  const Sample& oldest = window_[samples_ % kWindow];
  const Sample& newest = window_[(samples_ + kWindow - 1) % kWindow];
  const double closer_m = (oldest.to_goal_m - newest.to_goal_m) / (kWindow - 1);
  if (closer_m / moved_m > kProgressRatio) return Situation::Progress;
  return obstacles >= kManyObstacles ? Situation::NoProgressWithObstacles
                                     : Situation::NoProgressWithoutObstacles;
}

void RobotMomentum::adjust(Situation situation) {
  const Steps& steps = kSteps[static_cast<std::size_t>(situation)];
  const auto step = [this](const Span& span) { return chance_.uniform(span.low, span.high); };
  gains_.goal = within(gains_.goal + step(steps.goal), kGoal);
  const double obstacle = gains_.obstacle + step(steps.obstacle);
  gains_.noise = within(gains_.noise + step(steps.noise), kNoise);
  gains_.obstacle =
      std::clamp(obstacle, std::min(gains_.goal + gains_.noise, kMostObstacle), kMostObstacle);
  gains_.sphere_m = within(gains_.sphere_m + step(steps.sphere_m), kSphereM);
  const auto hop = static_cast<double>(chance_.below(2));
  const double persistence = static_cast<double>(gains_.persistence) + steps.persistence.low + hop;
  gains_.persistence = static_cast<std::int64_t>(within(persistence, kPersistence));
}

void RobotMomentum::resume(const Gains& gains, std::uint64_t chance_position) {
  gains_ = gains;
  chance_.seek(chance_position);
  samples_ = 0;
}

}  // namespace tacit
