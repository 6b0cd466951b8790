#include "deploy/tacit/run_debrief.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "console/debrief/debrief.h"
#include "console/record/event_reader.h"
#include "console/record/record_error.h"
#include "deploy/lockstep/setup.h"
#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "idl/types/operation_script.h"

namespace tacit {
namespace {

MapPlan plan_in(const OperationScript& script, Doors doors, const std::string& file) {
  const OverlayReading reading = read_overlay(script.map);
  for (const MapFinding& finding : reading.findings) {
    if (finding.severity == Severity::Error) {
      throw ConfigError(to_text(finding, file + ": [operation] map"));
    }
  }
  return plan_of(reading.map, doors);
}

Debrief::Config config_of(const Setup& setup, const OperationScript& script,
                          const std::string& file) {
  const auto robots = static_cast<std::int64_t>(script.starts.size());
  if (script.extra_count >= robots) {
    throw ConfigError(file + ": [operation] extra_count = " + std::to_string(script.extra_count) +
                      ": of " + std::to_string(robots) +
                      " robots in starts none is left for the team; wanted fewer");
  }
  return {static_cast<std::size_t>(robots - script.extra_count),
          script.extra_count > 0 && script.extra_colour == "red",
          setup.world.area.doors == "closed" ? Doors::Closed : Doors::Open,
          setup.world.physics.tick_s};
}

/// In characters; UTF-8's continuation bytes take no place.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

}  // namespace

std::optional<Checklist> debrief_of(const RunDirectory& directory) {
  ScenarioFile file = ScenarioFile::read(directory.scenario_file());
  Setup setup;
  file.fill(setup);
  if (mission_kind(setup.run) != MissionKind::Operation) return std::nullopt;
  OperationScript script;
  file.fill(script);
  const Debrief::Config config = config_of(setup, script, file.name());
  Debrief debrief(plan_in(script, config.doors, file.name()), config);
  try {
    read_events(directory.events_file(), [&debrief](const Event& event) { debrief.add(event); });
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
  return debrief.result();
}

std::string checklist_text(const Checklist& list) {
  std::size_t widest = 0;
  for (const SubTask& task : list.tasks) {
    widest = std::max(widest, width(task.name));
  }
  std::string text = "Debrief: " + std::to_string(list.done()) + " of " +
                     std::to_string(list.wanted()) + " sub-tasks done";
  for (const SubTask& task : list.tasks) {
    text += std::string(task.done ? "\n  [x] " : "\n  [ ] ") + task.name +
            std::string(widest - width(task.name) + 2, ' ') + task.evidence;
  }
  return text;
}

std::string checklist_json(const Checklist& list) {
  using Json = nlohmann::ordered_json;
  Json tasks = Json::array();
  for (const SubTask& task : list.tasks) {
    tasks.push_back({{"name", task.name}, {"done", task.done}, {"evidence", task.evidence}});
  }
  const Json all{{"done", list.done()}, {"wanted", list.wanted()}, {"tasks", tasks}};
  // Names on a map need not be UTF-8.
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tacit
