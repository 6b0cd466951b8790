#include "console/server/run_list.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "console/server/run_facts.h"
#include "idl/bus/venue_file.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string state_of(const RunDirectory& directory, const std::optional<RunOutcome>& outcome) {
  if (outcome && outcome->complete) return "done";
  if (VenueFile::read(directory.path())) return "live";
  return outcome ? "stopped" : "failed";
}

std::optional<RunOutcome> outcome_of(const RunDirectory& directory) {
  try {
    return directory.outcome();
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

Json summary(const std::string& id, const RunDirectory& directory) {
  const std::optional<RunOutcome> outcome = outcome_of(directory);
  const RunFacts& facts = directory.facts();
  return {{"id", id},
          {"name", id},
          {"scenario", facts.scenario},
          {"seed", facts.seed},
          {"state", state_of(directory, outcome)},
          {"started", facts.started},
          {"ticks", outcome ? outcome->ticks : 0},
          {"robots", facts.robots},
          {"learner", facts.learner},
          {"strategy", facts.strategy},
          {"version", facts.version},
          {"recording", fs::exists(directory.path() / "run.mcap")},
          {"score", nullptr}};
}

Json metrics_of(const RunOutcome& outcome) {
  Json list = Json::array();
  for (const RecordedMetric& metric : outcome.metrics) {
    Json value;
    if (metric.value) std::visit([&](auto number) { value = number; }, *metric.value);
    list.push_back({{"name", metric.key}, {"value", value}, {"unit", ""}, {"meaning", ""}});
  }
  return list;
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

bool RunList::is_id(const std::string& id) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !id.empty() && id.size() <= 200 && id.front() != '.' &&
         std::all_of(id.begin(), id.end(), fits);
}

RunDirectory RunList::open(const std::string& id) const {
  if (!is_id(id) || !fs::is_directory(folder_ / id)) {
    throw ConfigError("there is no run " + id + " in " + folder_.string());
  }
  return RunDirectory::open(folder_ / id);
}

std::optional<LiveRunFacts> RunList::live(const std::string& id) const {
  const std::optional<Venue> venue = VenueFile::read(folder_ / id);
  if (!venue) return std::nullopt;
  const RunDirectory directory = open(id);
  return LiveRunFacts{*venue, directory.facts().robots, tick_s_of(directory)};
}

std::vector<std::string> RunList::live_ids() const {
  std::vector<std::string> ids;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    const std::string id = entry.path().filename().string();
    if (is_id(id) && fs::exists(entry.path() / "live", error)) ids.push_back(id);
  }
  return ids;
}

std::string RunList::to_json() const {
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    const std::string id = entry.path().filename().string();
    const fs::path facts = entry.path() / "run.json";
    if (is_id(id) && fs::exists(facts, error)) {
      found.emplace_back(fs::last_write_time(facts, error), id);
    }
  }
  std::sort(found.rbegin(), found.rend());
  found.resize(std::min(found.size(), kMost));
  Json list = Json::array();
  for (const auto& [time, id] : found) {
    try {
      list.push_back(summary(id, open(id)));
    } catch (const ConfigError&) {
      // A folder that is no run any more, or not yet.
    }
  }
  return dumped(list);
}

std::string RunList::to_json(const std::string& id, const std::string& checklist) const {
  const RunDirectory directory = open(id);
  Json one = summary(id, directory);
  const std::optional<RunOutcome> outcome = outcome_of(directory);
  one["metrics"] = outcome ? metrics_of(*outcome) : Json::array();
  one["checklist"] = nullptr;
  const Json list = Json::parse(checklist, nullptr, false);
  if (list.is_object() && list.contains("tasks")) {
    one["checklist"] = list["tasks"];
    one["score"] = {{"done", list.value("done", 0)}, {"wanted", list.value("wanted", 0)}};
  }
  return dumped(one);
}

bool RunList::is_over(const std::string& id) const {
  const std::optional<RunOutcome> outcome = outcome_of(open(id));
  return outcome && outcome->complete;
}

}  // namespace tacit
