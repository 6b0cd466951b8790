#include "deploy/tacit/replay_info.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "console/record/event_log.h"

namespace tacit {
namespace {

using nlohmann::json;

constexpr double kSecond_ns = 1e9;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 2, width), ' ');
  return text;
}

void take_events(const TapeReader& tape, ReplayInfo& info) {
  EventHash hash;
  tape.events([&](const Event& event) {
    hash.add({&event, 1});
    ++info.events;
  });
  info.event_log_sha256 = hash.hex();
}

/// What the event log that was written beside the recording has to do with it.
std::string verdict(const ReplayInfo& info) {
  const auto outcome = info.metadata.find("outcome");
  if (outcome == info.metadata.end()) return "the recording was cut off";
  const auto hash = outcome->second.find("event_log_sha256");
  const bool same = hash != outcome->second.end() && hash->second == info.event_log_sha256;
  return same ? "as the run's event log" : "NOT the run's event log";
}

}  // namespace

ReplayInfo info_of(const TapeReader& tape) {
  const McapReader& mcap = tape.mcap();
  ReplayInfo info;
  info.trouble = mcap.trouble();
  if (info.trouble.empty() && !mcap.data_checksum_holds()) {
    info.trouble = "the checksum of its data is wrong";
  }
  for (const auto& [id, channel] : mcap.channels()) info.messages[channel.topic] = 0;
  for (const auto& [id, count] : mcap.statistics().of_channel) {
    const auto channel = mcap.channels().find(id);
    if (channel != mcap.channels().end()) info.messages[channel->second.topic] += count;
  }
  for (const auto& index : mcap.attachments()) info.attachments[index.name] = index.data_size;
  for (const auto& metadata : mcap.metadata()) info.metadata[metadata.name] = metadata.values;
  info.begin_s = static_cast<double>(mcap.statistics().start_ns) / kSecond_ns;
  info.end_s = static_cast<double>(mcap.statistics().end_ns) / kSecond_ns;
  take_events(tape, info);
  return info;
}

std::string info_text(const ReplayInfo& info) {
  std::ostringstream text;
  if (!info.trouble.empty()) text << "not whole: " << info.trouble << "\n\n";
  for (const auto& [name, values] : info.metadata) {
    text << name << '\n';
    for (const auto& [key, value] : values) text << "  " << padded(key, 22) << value << '\n';
  }
  text << "simulated time          " << info.begin_s << " s to " << info.end_s << " s\n"
       << "events                  " << info.events << ", SHA-256 " << info.event_log_sha256 << ", "
       << verdict(info) << "\n\nchannel                           messages\n";
  for (const auto& [topic, count] : info.messages) text << padded(topic, 34) << count << '\n';
  text << "\nattachment                        bytes\n";
  for (const auto& [name, bytes] : info.attachments) text << padded(name, 34) << bytes << '\n';
  return text.str();
}

std::string info_json(const ReplayInfo& info) {
  return json{{"trouble", info.trouble},         {"channels", info.messages},
              {"attachments", info.attachments}, {"metadata", info.metadata},
              {"begin_s", info.begin_s},         {"end_s", info.end_s},
              {"events", info.events},           {"event_log_sha256", info.event_log_sha256}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace tacit
