#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "idl/types/frames.h"
#include "idl/types/ids.h"
#include "idl/types/parameters.h"

namespace tacit {

/// How a pursued enemy and the robot itself have moved of late, by dead reckoning.
///
/// Sightings carry no identity, so the enemy pursued now is taken for the one pursued a tick ago
/// when it lies within a gate of where that one was expected; otherwise a new track begins.
class QuarryTrack {
 public:
  struct Config {
    std::int64_t average_ticks = 5;  ///< >= 1
    double gate_m = 0.5;             ///< More than an enemy travels in one tick.
  };
  /// Mean motion over the ticks tracked.
  struct Motion {
    OdometryVec quarry_m_per_tick;
    OdometryVec self_m_per_tick;
  };

  /// Where the quarry and the robot were at one tick.
  struct Fix {
    OdometryVec quarry_m;
    OdometryVec self_m;
  };
  /// All that a track remembers.
  struct Record {
    std::vector<Fix> fixes;   ///< A ring.
    std::uint64_t count = 0;  ///< Fixes of this track, also those overwritten.
    Tick last_tick = 0;
  };

  explicit QuarryTrack(const Config& config);

  /// Notes where the quarry and the robot are. A tick that does not follow the last one begins a
  /// new track.
  void note(Tick tick, const OdometryVec& quarry_m, const OdometryVec& self_m);
  /// Empty until the quarry has been seen in two successive ticks.
  [[nodiscard]] std::optional<Motion> motion() const;

  [[nodiscard]] Record record() const { return {fixes_, count_, last_tick_}; }
  /// Whether the record is one of a window of this length.
  [[nodiscard]] bool fits(const Record& record) const {
    return record.fixes.size() == fixes_.size();
  }
  /// Goes on from a record that fits.
  void resume(const Record& record);

 private:
  [[nodiscard]] bool continues(Tick tick, const OdometryVec& quarry_m) const;
  [[nodiscard]] const Fix& fix(std::uint64_t number) const {
    return fixes_[number % fixes_.size()];
  }

  double gate_m_;
  std::vector<Fix> fixes_;   ///< A ring.
  std::uint64_t count_ = 0;  ///< Fixes of this track, also those overwritten.
  Tick last_tick_ = 0;
};

void describe(QuarryTrack::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
