#include "robot_agent/brain/learning/learning_momentum.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "idl/types/config_error.h"
#include "idl/types/shortest.h"

namespace tacit {
namespace {

struct Adapted {
  std::string_view key;
  double AdaptedGains::*value;
  std::size_t schema;
};
constexpr std::array<Adapted, 3> kAdapted{{
    {MoveToTarget::kKey, &AdaptedGains::move_to_target, kSchemaIndex<MoveToTarget>},
    {InterceptEnemies::kKey, &AdaptedGains::intercept, kSchemaIndex<InterceptEnemies>},
    {AvoidSoldiers::kKey, &AdaptedGains::avoid_soldiers, kSchemaIndex<AvoidSoldiers>},
}};

constexpr std::string_view kMemoryStart = R"({"learner":"lm")";

std::string to_memory(const Gains& gains) {
  std::string text(kMemoryStart);
  for (const Adapted& gain : kAdapted) {
    text.append(",\"").append(gain.key).append("\":").append(shortest(gains.value[gain.schema]));
  }
  return text.append("}");
}

/// Cuts `start` off the front of `text`; false when it is not there.
bool cut(std::string_view& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.remove_prefix(start.size());
  return true;
}

std::optional<double> cut_number(std::string_view& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

void check_bounds(const LearningMomentum::Config& config, const Adapted& gain) {
  const double low = config.min.*gain.value;
  const double high = config.max.*gain.value;
  const double initial = config.initial.value[gain.schema];
  if (low <= initial && initial <= high) return;
  throw ConfigError("brain.lm.initial." + std::string(gain.key) + " is " + shortest(initial) +
                    ", wanted between brain.lm.min and brain.lm.max, which are " + shortest(low) +
                    " and " + shortest(high));
}

}  // namespace

LearningMomentum::LearningMomentum(const Config& config, const SituationConfig& situation,
                                   const Occlusion& occlusion)
    : config_(config), situation_config_(situation), occlusion_(occlusion), gains_(config.initial) {
  for (const Adapted& gain : kAdapted) check_bounds(config, gain);
}

void LearningMomentum::learn(const Surroundings& around) {
  const std::uint64_t period = around.tick / static_cast<Tick>(config_.period_ticks);
  if (period == period_) return;
  period_ = period;
  situation_ = tacit::situation(around, occlusion_, situation_config_);
  adapt(*situation_);
}

void LearningMomentum::adapt(Situation now) {
  const auto row = std::find_if(kTable1.begin(), kTable1.end(),
                                [now](const Adjustment& each) { return each.situation == now; });
  for (const Adapted& gain : kAdapted) {
    double& value = gains_.value[gain.schema];
    value = std::clamp(value + row->delta.*gain.value, config_.min.*gain.value,
                       config_.max.*gain.value);
  }
}

Gains LearningMomentum::ceiling() const {
  Gains gains = config_.initial;
  for (const Adapted& gain : kAdapted) gains.value[gain.schema] = config_.max.*gain.value;
  return gains;
}

std::string_view LearningMomentum::situation() const {
  return situation_ ? name(*situation_) : std::string_view{};
}

std::string LearningMomentum::memory() const { return to_memory(gains_); }

bool LearningMomentum::recall(std::string_view text) {
  Gains gains = gains_;
  std::string_view rest = text;
  if (!cut(rest, kMemoryStart)) return false;
  for (const Adapted& gain : kAdapted) {
    if (!cut(rest, ",\"") || !cut(rest, gain.key) || !cut(rest, "\":")) return false;
    const auto value = cut_number(rest);
    if (!value || *value < config_.min.*gain.value || *value > config_.max.*gain.value) {
      return false;
    }
    gains.value[gain.schema] = *value;
  }
  if (to_memory(gains) != text) return false;
  gains_ = gains;
  return true;
}

void describe(LearningMomentum::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.lm", "Learning momentum: gains shifted by the paper's Table 1.");
  visitor.integer("period_ticks", config.period_ticks, {1, 1e9},
                  {"ticks", "Ticks from one shift of the gains to the next [MissionLab]."});
  visitor.section("brain.lm.initial", "Gains at tick 0; those not adapted stay so.");
  for_each_schema([&]<class S>() {
    visitor.number(S::kKey, config.initial.of<S>(), {0.0, 1000.0},
                   {"", "Weight of this schema at tick 0 [ours: the paper gives no weights]."});
  });
  visitor.section("brain.lm.min", "Lower bounds of the adapted gains.");
  for (const Adapted& gain : kAdapted) {
    visitor.number(gain.key, config.min.*gain.value, {0.0, 1000.0},
                   {"",
                    "Lowest weight of this schema [ours: MoveToTarget a little below Static1's, by "
                    "tuning; no schema ever falls silent]."});
  }
  visitor.section("brain.lm.max", "Upper bounds of the adapted gains.");
  for (const Adapted& gain : kAdapted) {
    visitor.number(gain.key, config.max.*gain.value, {0.0, 1000.0},
                   {"",
                    "Highest weight of this schema [ours: at rest the very gains of Static2, which "
                    "are stable]."});
  }
}

}  // namespace tacit
