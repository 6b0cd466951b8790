#pragma once

#include <array>
#include <cstdint>

#include "idl/types/random.h"

namespace tacit {

/// Learning momentum for one robot (MissionLab's lmadjust): gains that grow and shrink with the
/// progress towards a goal, by uniform random steps.
///
/// Every tick takes a sample; every tenth tick after the fifth tells the situation from the last
/// five samples and adjusts.
class RobotMomentum {
 public:
  struct Gains {
    double goal = 1.0;
    double obstacle = 1.0;
    double noise = 0.0;
    double sphere_m = 1.0;          ///< Within which obstacles push.
    std::int64_t persistence = 10;  ///< Of noise [ticks].
    friend bool operator==(const Gains&, const Gains&) = default;
  };
  enum class Situation : std::uint8_t {
    NoMovement,
    Progress,
    NoProgressWithObstacles,
    NoProgressWithoutObstacles,
  };
  struct Sample {
    double moved_m = 0.0;    ///< Since the tick before.
    double to_goal_m = 0.0;  ///< The distance left.
    double obstacles = 0.0;  ///< That push.
  };
  static constexpr std::size_t kWindow = 5;
  static constexpr std::uint64_t kInterval = 10;

  RobotMomentum(const Gains& initial, Stream chance) : gains_(initial), chance_(chance) {}

  /// Whether the gains were adjusted.
  bool note(const Sample& sample);
  [[nodiscard]] const Gains& gains() const { return gains_; }
  /// By the samples in the window, which is full.
  [[nodiscard]] Situation situation() const;
  [[nodiscard]] std::uint64_t chance_position() const { return chance_.position(); }
  /// Goes on with these gains; the window begins anew.
  void resume(const Gains& gains, std::uint64_t chance_position);

 private:
  void adjust(Situation situation);

  Gains gains_;
  Stream chance_;
  std::array<Sample, kWindow> window_{};  ///< A ring.
  std::uint64_t samples_ = 0;
};

}  // namespace tacit
