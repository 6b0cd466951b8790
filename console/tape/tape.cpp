#include "console/tape/tape.h"

#include <algorithm>
#include <cmath>

#include "console/record/json.h"
#include "console/tape/markers.h"
#include "console/tape/scene.h"
#include "idl/schema/schema.h"

namespace tacit {
namespace {

constexpr double kSecond_ns = 1e9;

std::uint64_t nanoseconds(double time_s) {
  return static_cast<std::uint64_t>(std::llround(time_s * kSecond_ns));
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

mcap::Metadata metadata_of(const RunFacts& facts) {
  return {"run",
          {{"key", facts.key},
           {"version", facts.version},
           {"scenario", facts.scenario},
           {"seed", std::to_string(facts.seed)},
           {"transport", facts.transport},
           {"robots", std::to_string(facts.robots)},
           {"learner", facts.learner},
           {"strategy", std::to_string(facts.strategy)},
           {"started", facts.started},
           {"command_line", joined(facts.command_line)}}};
}

mcap::Metadata metadata_of(const RunOutcome& outcome) {
  return {"outcome",
          {{"complete", outcome.complete ? "true" : "false"},
           {"incomplete_because", outcome.incomplete_because},
           {"repeatable", outcome.repeatable ? "true" : "false"},
           {"ticks", std::to_string(outcome.ticks)},
           {"events", std::to_string(outcome.events)},
           {"event_log_sha256", outcome.event_log_sha256}}};
}

}  // namespace

Tape::Tape(const std::filesystem::path& file, const RunFacts& facts, std::string_view scenario_toml)
    : writer_(file, {"tacit " + facts.version}),
      scenery_(scenery_of(scenario_toml, file.string())) {
  writer_.note(metadata_of(facts));
  writer_.attach({0, 0, "scenario.toml", "application/toml", std::string(scenario_toml)});
  if (!scenery_.map.empty()) writer_.attach({0, 0, "map.ovl", "text/plain", scenery_.map});
  view_ = channel_of<topics::WorldView>();
  status_ = channel_of<topics::Status>();
  events_ = channel_of<topics::Events>();
  scene_ = channel("/tacit/scene", kMarkerArray, marker_array_schema());
  walls_ = channel("/tacit/walls", kMarkerArray, marker_array_schema());
  // A file that is cut off early should still say what it is.
  writer_.flush();
}

std::uint16_t Tape::channel(std::string_view topic, std::string_view schema,
                            std::string_view text) {
  auto known = schemas_.find(schema);
  if (known == schemas_.end()) {
    known = schemas_.emplace(schema, writer_.add_schema(schema, "ros2msg", text)).first;
  }
  return writer_.add_channel(known->second, topic, "cdr");
}

template <class Topic>
std::uint16_t Tape::channel_of(RobotId robot) {
  const WireSchema schema = schema_of<Topic>();
  return channel('/' + topic_name<Topic>(robot), schema.name, schema.text);
}

std::uint64_t Tape::time_of(Tick tick) const {
  return nanoseconds(static_cast<double>(tick) * scenery_.tick_s);
}

void Tape::add(const WorldView& view, Bytes bytes) {
  const std::uint64_t time_ns = time_of(view.tick);
  newest_ns_ = std::max(newest_ns_, time_ns);
  writer_.write(view_, time_ns, bytes);
  show(view, time_ns);
}

void Tape::show(const WorldView& view, std::uint64_t time_ns) {
  if (!walls_shown_) {
    writer_.write(walls_, time_ns, marker_array(still_scene(scenery_), time_ns));
    walls_shown_ = true;
  }
  writer_.write(scene_, time_ns,
                marker_array(moving_scene(view, scenery_.robot_radius_m), time_ns));
}

void Tape::add(const RunStatus& status, Bytes bytes) {
  writer_.write(status_, time_of(status.tick), bytes);
}

/// A batch is told once its last event has happened.
void Tape::add(const EventBatch& batch, Bytes bytes) {
  const Tick tick = batch.events.empty() ? 0 : batch.events.back().tick;
  newest_ns_ = std::max(newest_ns_, time_of(tick));
  writer_.write(events_, time_of(tick), bytes);
}

void Tape::add(const Telemetry& telemetry, Bytes bytes) {
  auto known = telemetry_.find(telemetry.robot);
  if (known == telemetry_.end()) {
    known =
        telemetry_.emplace(telemetry.robot, channel_of<topics::Telemetry>(telemetry.robot)).first;
  }
  writer_.write(known->second, time_of(telemetry.tick), bytes);
}

void Tape::finish(const RunOutcome& outcome) {
  writer_.attach({newest_ns_, 0, "metrics.json", "application/json", to_json(outcome)});
  writer_.note(metadata_of(outcome));
  writer_.close();
}

std::filesystem::path spare_name(const std::filesystem::path& file) {
  std::filesystem::path spare = file;
  for (int number = 1; std::filesystem::exists(spare); ++number) {
    spare.replace_filename(file.stem().string() + '.' + std::to_string(number) +
                           file.extension().string());
  }
  return spare;
}

}  // namespace tacit
