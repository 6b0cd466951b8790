#include "deploy/tacit/summary.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "console/record/json.h"
#include "deploy/tacit/run_debrief.h"

namespace tacit {

std::string summary_json(const RunDirectory& directory, const RunOutcome& outcome,
                         const std::optional<Checklist>& checklist) {
  using Json = nlohmann::ordered_json;
  const RunFacts& facts = directory.facts();
  const std::optional<double> speed = outcome.ticks_per_s();
  Json summary{{"scenario", facts.scenario},
               {"seed", facts.seed},
               {"version", facts.version},
               {"transport", facts.transport},
               {"ticks", outcome.ticks},
               {"wall_s", outcome.wall_s},
               {"ticks_per_s", speed ? Json(*speed) : Json()},
               {"event_log_sha256", outcome.event_log_sha256},
               {"metrics", Json::parse(to_json(outcome.metrics))},
               {"run_dir", directory.path().string()},
               {"complete", outcome.complete},
               {"repeatable", outcome.repeatable}};
  if (checklist) {
    summary["checklist"] = Json::parse(checklist_json(*checklist));
  }
  return summary.dump();
}

std::string summary_text(const RunDirectory& directory, const RunOutcome& outcome) {
  std::string text = std::to_string(outcome.ticks) + " ticks";
  if (const std::optional<double> speed = outcome.ticks_per_s()) {
    text += ", " + std::to_string(std::lround(*speed)) + " per second";
  }
  text += "\nevent log " + outcome.event_log_sha256 + "\nrecorded in " + directory.path().string();
  if (!outcome.complete) {
    text += "\nThe run is incomplete: " + outcome.incomplete_because + '.';
  }
  if (!outcome.repeatable) {
    text +=
        "\nA robot was lost or late, or an operator acted: the run cannot be made again bit for "
        "bit.";
  }
  return text;
}

}  // namespace tacit
