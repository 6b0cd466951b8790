#include "deploy/tacit/learn_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "console/record/json.h"
#include "console/report/chart_axis.h"
#include "console/report/progress_text.h"

namespace tacit {
namespace {

const char* verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accomplished:
      return "accomplished";
    case Verdict::TeamLost:
      return "team lost";
    case Verdict::OutOfTime:
      return "out of time";
  }
  return "";
}

/// How the run ended, in a few words.
std::string ending_text(const Tally& tally) {
  const auto& forage = tally.of<Forage>();
  if (!forage.mines) {
    return standing_text(tally, 0);
  }
  return std::string(forage.end ? verdict_text(forage.end->verdict) : "not over") + "  mines " +
         std::to_string(forage.stored) + '/' + std::to_string(*forage.mines);
}

TableCell value_of(const Episode& episode, const char* metric) {
  const std::optional<double> value = episode.tally.value(metric);
  return value ? TableCell{*value} : TableCell{};
}

std::vector<double> values_of(std::span<const Episode> episodes, const char* metric) {
  std::vector<double> values;
  for (const Episode& episode : episodes) {
    if (const std::optional<double> value = episode.tally.value(metric)) {
      values.push_back(*value);
    }
  }
  return values;
}

std::vector<TableCell> stretch(const std::string& name, std::span<const Episode> episodes) {
  const auto score = mean(values_of(episodes, "score_ticks"));
  const std::vector<double> failed = values_of(episodes, "failed");
  double ticks = 0.0;
  for (const Episode& episode : episodes) {
    ticks += static_cast<double>(episode.ticks) / static_cast<double>(episodes.size());
  }
  return {name, static_cast<std::int64_t>(episodes.size()), ticks,
          score ? TableCell{*score} : TableCell{},
          static_cast<std::int64_t>(std::count(failed.begin(), failed.end(), 1.0))};
}

}  // namespace

std::string episode_text(const Episode& episode, std::int64_t episodes, double elapsed_s) {
  std::string text = "run " + std::to_string(episode.number) + '/' + std::to_string(episodes) +
                     "  seed " + std::to_string(episode.seed) + "  " +
                     axis_label(static_cast<double>(episode.ticks), 1.0) + " ticks  " +
                     ending_text(episode.tally);
  if (episode.number < episodes) {
    text += "  ETA " + clock_text(elapsed_s / static_cast<double>(episode.number) *
                                  static_cast<double>(episodes - episode.number));
  }
  return text;
}

Table episodes_table(std::span<const Episode> episodes) {
  Table table{"",
              {{"run", "run"},
               {"seed", "seed"},
               {"ticks", "ticks"},
               {"score_ticks", "score_ticks", 0},
               {"failed", "failed", 0}},
              {}};
  for (const Episode& episode : episodes) {
    table.rows.push_back({episode.number, episode.seed, static_cast<std::int64_t>(episode.ticks),
                          value_of(episode, "score_ticks"), value_of(episode, "failed")});
  }
  return table;
}

Table learned_table(std::span<const Episode> episodes, std::int64_t evaluate) {
  Table table{"Mean over the first and the last runs",
              {{"which", "which"},
               {"runs", "runs"},
               {"ticks", "ticks", 1},
               {"score_ticks", "score_ticks", 1},
               {"failed", "failed"}},
              {}};
  const std::size_t count = std::min(static_cast<std::size_t>(evaluate), episodes.size());
  table.rows.push_back(stretch("first", episodes.first(count)));
  table.rows.push_back(stretch("last", episodes.last(count)));
  return table;
}

std::string learned_json(const RunFacts& facts, const ChainLength& length,
                         const RunOutcome& outcome, const std::string& policy_dir) {
  using Json = nlohmann::ordered_json;
  Json scores = Json::array();
  for (std::int64_t run = 1; run <= length.episodes; ++run) {
    const std::string key =
        length.episodes > 1 ? "score_ticks_" + std::to_string(run) : "score_ticks";
    if (const std::optional<double> score = outcome.metric(key)) {
      scores.push_back(*score);
    }
  }
  const Json object{{"scenario", facts.scenario},
                    {"seed", facts.seed},
                    {"version", facts.version},
                    {"transport", facts.transport},
                    {"robots", facts.robots},
                    {"learner", facts.learner},
                    {"episodes", length.episodes},
                    {"evaluate", length.evaluate},
                    {"ticks", outcome.ticks},
                    {"wall_s", outcome.wall_s},
                    {"score_ticks", scores},
                    {"metrics", Json::parse(to_json(outcome.metrics))},
                    {"event_log_sha256", outcome.event_log_sha256},
                    {"policy_dir", policy_dir.empty() ? Json() : Json(policy_dir)}};
  return object.dump();
}

}  // namespace tacit
