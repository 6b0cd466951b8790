#include "deploy/tacit/preview_text.h"

#include <nlohmann/json.hpp>

#include "console/report/table.h"
#include "deploy/experiment/results.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

constexpr const char* kAlike =
    "All flights went the same way, so the intervals say little: nothing here draws chance. Noise\n"
    "does: --set sight.bearing_noise_deg=2 --set sight.range_noise_m=0.05\n";

using Json = nlohmann::ordered_json;

Json to_json(const std::optional<Estimate>& estimate) {
  if (!estimate) return {};
  return {{"value", estimate->value}, {"low", estimate->low}, {"high", estimate->high}};
}

Json to_json(const Flight& flight) {
  return {{"seed", flight.seed},
          {"done", flight.list.done()},
          {"wanted", flight.list.wanted()},
          {"score", flight.list.score()},
          {"full", flight.full()},
          {"time_s", flight.time_s},
          {"over", flight.over},
          {"failures", flight.failures()}};
}

Json to_json(const Weakness& weakness) {
  return {{"name", weakness.name},
          {"flights", weakness.flights},
          {"seed", weakness.seed},
          {"evidence", weakness.evidence}};
}

template <class Values>
Json list_of(const Values& values) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(to_json(value));
  return list;
}

/// With its interval when there are enough flights for one.
TableCell either(const std::optional<Estimate>& estimate, const std::optional<double>& value) {
  return estimate ? cell_of(estimate) : cell_of(value);
}

Table results_table(const Preview& preview, const PreviewFacts& facts) {
  const std::string beside = facts.extra.empty() ? "" : " beside " + facts.extra;
  Table table{facts.mission + " on " + facts.map + beside,
              {{"what", "what"}, {"value", "value, 95 % interval", 3, true}},
              {}};
  table.rows.push_back({std::string("all sub-tasks done"), cell_of(preview.success())});
  table.rows.push_back(
      {std::string("mean score"), either(preview.score(), mean(preview.scores()))});
  table.rows.push_back({std::string("median time (s, simulated)"),
                        either(preview.time_s(), median(preview.times_s()))});
  return table;
}

Table weakness_table(const std::vector<Weakness>& weaknesses) {
  Table table{"What was not always done",
              {{"name", "sub-task"},
               {"flights", "flights"},
               {"seed", "first seed"},
               {"evidence", "why, there"}},
              {}};
  for (const Weakness& one : weaknesses) {
    table.rows.push_back({one.name, static_cast<std::int64_t>(one.flights),
                          static_cast<std::int64_t>(one.seed), one.evidence});
  }
  return table;
}

}  // namespace

std::string preview_text(const Preview& preview, const PreviewFacts& facts) {
  std::string text = to_text(results_table(preview, facts));
  const std::vector<Weakness> weaknesses = preview.weaknesses();
  if (!weaknesses.empty()) text += '\n' + to_text(weakness_table(weaknesses));
  text += '\n' + std::to_string(preview.flights.size()) + " of " + std::to_string(preview.wanted) +
          " flights, seeds from " + std::to_string(facts.seed) + " on";
  text += preview.cut_short() ? "; cut short\n" : "\n";
  return text + (preview.alike() ? kAlike : "");
}

std::string preview_json(const Preview& preview, const PreviewFacts& facts) {
  const Json all{{"version", version()},
                 {"mission", facts.mission},
                 {"map", facts.map},
                 {"extra", facts.extra},
                 {"seed", facts.seed},
                 {"wanted", preview.wanted},
                 {"flown", preview.flights.size()},
                 {"cut_short", preview.cut_short()},
                 {"alike", preview.alike()},
                 {"success", to_json(preview.success())},
                 {"score", to_json(preview.score())},
                 {"time_s", to_json(preview.time_s())},
                 {"weaknesses", list_of(preview.weaknesses())},
                 {"flights", list_of(preview.flights)}};
  // Names on a map need not be UTF-8.
  return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tacit
