#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "idl/types/parameters.h"
#include "robot_agent/brain/learning/learner.h"
#include "robot_agent/brain/perception/situation.h"

namespace tacit {

/// A number for each of the three gains that learning momentum adapts.
struct AdaptedGains {
  double move_to_target = 0.0;
  double intercept = 0.0;
  double avoid_soldiers = 0.0;
};

/// The paper's Table 1, "Behavioral weight adjustments for different situations", row by row.
struct Adjustment {
  Situation situation;
  AdaptedGains delta;
};
// clang-format off
inline constexpr std::array<Adjustment, 5> kTable1{{
    //                              MoveToTarget  Intercept  AvoidSoldiers
    {Situation::AllClear,           {0.05,        -0.05,      0.05}},
    {Situation::FlankingEnemy,      {-0.1,         0.1,      -0.1}},
    {Situation::ClearToEnemy,       {-0.1,         0.1,       0.1}},
    {Situation::SoldierNeedsHelp,   {-0.1,         0.1,      -0.1}},
    {Situation::NoSoldiersNeedHelp, {0.1,         -0.1,      -0.1}},
}};
// clang-format on

/// Learning momentum (paper, section 2): every so many ticks the robot judges its situation and
/// shifts three gains by the row of Table 1, each within its bounds. The other gains stay.
class LearningMomentum final : public Learner {
 public:
  struct Config {
    std::int64_t period_ticks = 10;  ///< >= 1
    Gains initial;                   ///< Of schemas not adapted: for good.
    AdaptedGains min{0.37, 0.1, 0.1};
    AdaptedGains max{1.0, 1.0, 0.3};
  };
  /// Throws ConfigError unless min <= initial <= max for each adapted gain.
  LearningMomentum(const Config& config, const SituationConfig& situation,
                   const Occlusion& occlusion);

  /// Adapts at the ticks that are multiples of the period, 0 excepted; when percepts were missed,
  /// at the first one after such a tick.
  void learn(const Surroundings& around) override;
  [[nodiscard]] const Gains& gains() const override { return gains_; }
  [[nodiscard]] Gains ceiling() const override;
  [[nodiscard]] std::string_view situation() const override;
  [[nodiscard]] std::string memory() const override;
  [[nodiscard]] bool recall(std::string_view text) override;

 private:
  void adapt(Situation now);

  Config config_;
  SituationConfig situation_config_;
  Occlusion occlusion_;
  Gains gains_;
  std::optional<Situation> situation_;
  std::uint64_t period_ = 0;  ///< Whole periods at the last adaption.
};

void describe(LearningMomentum::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
