#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "console/metrics/tally.h"
#include "console/record/event_log.h"
#include "console/record/run.h"
#include "deploy/lockstep/setup.h"
#include "idl/types/policy_text.h"

namespace tacit {

class Team;

/// One finished run of a chain.
struct Episode {
  std::int64_t number = 0;  ///< From 1.
  std::int64_t seed = 0;
  Tick ticks = 0;
  Tally tally;
};

/// How many runs there are in a chain, and how many of them, the last ones, count.
struct ChainLength {
  std::int64_t episodes = 1;
  std::int64_t evaluate = 1;  ///< At most `episodes`.
};

/// Runs in a row with seeds s, s+1, …: in each, every robot begins with what it has learned in
/// those before. A team that does not learn begins each anew.
class Chain {
 public:
  /// `setup` is that of the first run, `policies` what it begins with; empty: with nothing learned.
  Chain(Setup setup, ChainLength length, std::vector<PolicyText> policies = {});

  [[nodiscard]] bool done() const {
    return static_cast<std::int64_t>(episodes_.size()) == length_.episodes;
  }
  /// Makes the next run. `end_wanted` is asked now and then; when it says yes, nothing is returned,
  /// the chain is at its end and holds what the finished runs gave. Call while not `done()`.
  [[nodiscard]] std::optional<Episode> next(const std::function<bool()>& end_wanted);

  /// The finished runs.
  [[nodiscard]] const std::vector<Episode>& episodes() const { return episodes_; }
  /// What each robot has learned in them; robot i+1 at index i. Empty when none has.
  [[nodiscard]] const std::vector<PolicyText>& policies() const { return policies_; }

  /// The whole chain as one run; call when `done()`. Ticks and events are those of all runs, the
  /// hash is over their event logs in order. A chain of one run has its metrics; a longer one the
  /// means of those that count, and, where there is a score, score_ticks_1, score_ticks_2, … of
  /// every run.
  [[nodiscard]] RunOutcome outcome(double wall_s) const;

 private:
  /// False when told to stop before the run's end.
  bool make_ticks(Team& team, Tally& tally, const std::function<bool()>& end_wanted);
  void take(std::span<const Event> events, Tally& tally);

  Setup setup_;
  ChainLength length_;
  std::vector<PolicyText> policies_;
  std::vector<Episode> episodes_;
  EventHash log_;
  std::uint64_t events_ = 0;
};

}  // namespace tacit
