#include "robot_agent/brain/perception/quarry_track.h"

#include <algorithm>
#include <cassert>

namespace tacit {

QuarryTrack::QuarryTrack(const Config& config)
    : gate_m_(config.gate_m), fixes_(static_cast<std::size_t>(config.average_ticks) + 1) {}

void QuarryTrack::note(Tick tick, const OdometryVec& quarry_m, const OdometryVec& self_m) {
  if (!continues(tick, quarry_m)) count_ = 0;
  fixes_[count_ % fixes_.size()] = {quarry_m, self_m};
  ++count_;
  last_tick_ = tick;
}

std::optional<QuarryTrack::Motion> QuarryTrack::motion() const {
  if (count_ < 2) return std::nullopt;
  const std::uint64_t steps = std::min<std::uint64_t>(count_, fixes_.size()) - 1;
  const Fix& newest = fix(count_ - 1);
  const Fix& oldest = fix(count_ - 1 - steps);
  const double scale = 1.0 / static_cast<double>(steps);
  return Motion{scale * (newest.quarry_m - oldest.quarry_m),
                scale * (newest.self_m - oldest.self_m)};
}

void QuarryTrack::resume(const Record& record) {
  assert(fits(record));
  fixes_ = record.fixes;
  count_ = record.count;
  last_tick_ = record.last_tick;
}

bool QuarryTrack::continues(Tick tick, const OdometryVec& quarry_m) const {
  if (count_ == 0 || tick != last_tick_ + 1) return false;
  OdometryVec expected_m = fix(count_ - 1).quarry_m;
  if (const auto moved = motion()) expected_m += moved->quarry_m_per_tick;
  return (quarry_m - expected_m).squared_norm() <= gate_m_ * gate_m_;
}

void describe(QuarryTrack::Config& config, ParameterVisitor& visitor) {
  visitor.integer("average_ticks", config.average_ticks, {1, 100},
                  {"ticks", "Window over which speeds are averaged for leading [MissionLab]."});
  visitor.number("gate_m", config.gate_m, {0.0, 100.0},
                 {"m",
                  "An enemy this near to where the pursued one was expected is taken for the same "
                  "[ours: three times an enemy's way in a tick]."});
}

}  // namespace tacit
