#include "deploy/experiment/chain.h"

#include <cassert>
#include <utility>

#include "console/report/estimate.h"
#include "deploy/lockstep/team.h"

namespace tacit {
namespace {

constexpr Tick kLook = 1024;
constexpr const char* kScore = "score_ticks";

RecordedMetric mean_of(const std::string& key, std::span<const Episode> episodes) {
  std::vector<double> values;
  for (const Episode& episode : episodes) {
    if (const std::optional<double> value = episode.tally.value(key)) {
      values.push_back(*value);
    }
  }
  return {key, measured(mean(values))};
}

std::vector<RecordedMetric> means(std::span<const Episode> episodes) {
  std::vector<RecordedMetric> all = recorded(episodes.back().tally);
  for (RecordedMetric& metric : all) {
    metric = mean_of(metric.key, episodes);
  }
  return all;
}

/// The score of every run, where there is one.
std::vector<RecordedMetric> learning_curve(std::span<const Episode> episodes) {
  std::vector<RecordedMetric> curve;
  for (const Episode& episode : episodes) {
    if (const std::optional<double> score = episode.tally.value(kScore)) {
      curve.push_back({std::string(kScore) + '_' + std::to_string(episode.number), *score});
    }
  }
  return curve;
}

std::vector<PolicyText> named(const std::vector<std::string>& texts, std::int64_t episode) {
  std::vector<PolicyText> policies;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    policies.push_back({texts[i], "policy of robot " + std::to_string(i + 1) + " after run " +
                                      std::to_string(episode)});
  }
  return policies;
}

}  // namespace

Chain::Chain(Setup setup, ChainLength length, std::vector<PolicyText> policies)
    : setup_(std::move(setup)), length_(length), policies_(std::move(policies)) {
  assert(length.evaluate >= 1 && length.evaluate <= length.episodes);
}

void Chain::take(std::span<const Event> events, Tally& tally) {
  log_.add(events);
  events_ += events.size();
  for (const Event& event : events) {
    tally.add(event);
  }
}

bool Chain::make_ticks(Team& team, Tally& tally, const std::function<bool()>& end_wanted) {
  while (!team.done(last_tick(setup_))) {
    if (team.tick() % kLook == 0 && end_wanted()) {
      return false;
    }
    take(team.step(), tally);
  }
  const Event ending = team.ending();
  take({&ending, 1}, tally);
  return true;
}

std::optional<Episode> Chain::next(const std::function<bool()>& end_wanted) {
  assert(!done());
  Team team(setup_.world, setup_.brain, seed(setup_));
  if (!policies_.empty()) {
    team.inherit(policies_);
  }
  Episode episode{static_cast<std::int64_t>(episodes_.size()) + 1, setup_.run.seed, 0, {}};
  if (!make_ticks(team, episode.tally, end_wanted)) {
    return std::nullopt;
  }
  episode.ticks = team.tick();
  if (learns(setup_.brain)) {
    policies_ = named(team.policies(), episode.number);
  }
  ++setup_.run.seed;
  episodes_.push_back(episode);
  return episode;
}

RunOutcome Chain::outcome(double wall_s) const {
  assert(done());
  RunOutcome outcome;
  outcome.complete = true;
  outcome.repeatable = true;
  for (const Episode& episode : episodes_) {
    outcome.ticks += episode.ticks;
  }
  outcome.events = events_;
  outcome.wall_s = wall_s;
  outcome.event_log_sha256 = log_.hex();
  outcome.metrics = recorded(episodes_.back().tally);
  if (length_.episodes > 1) {
    outcome.metrics = means(std::span(episodes_).last(static_cast<std::size_t>(length_.evaluate)));
    const std::vector<RecordedMetric> curve = learning_curve(episodes_);
    outcome.metrics.insert(outcome.metrics.end(), curve.begin(), curve.end());
  }
  return outcome;
}

}  // namespace tacit
