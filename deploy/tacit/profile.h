#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "console/report/table.h"
#include "deploy/lockstep/team.h"

namespace tacit {

/// Where the time of a team in one process goes: the brains, each phase of the world's step, and
/// the rest.
class Profile {
 public:
  /// Watches `team` from now on; `team` outlives this.
  explicit Profile(Team& team);
  ~Profile();
  Profile(const Profile&) = delete;
  Profile& operator=(const Profile&) = delete;

  /// A part a row, with its time per tick and its share.
  [[nodiscard]] Table table() const;

 private:
  using Clock = std::chrono::steady_clock;

  void end_of(TeamPhase phase);

  Team& team_;
  Clock::time_point last_ = Clock::now();
  std::array<Clock::duration, kTeamPhases> spent_{};  ///< Per phase.
  std::uint64_t ticks_ = 0;
};

}  // namespace tacit
