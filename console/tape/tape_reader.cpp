#include "console/tape/tape_reader.h"

#include <algorithm>

#include "idl/bus/cdr.h"
#include "idl/schema/schema.h"
#include "idl/types/event_batch.h"

namespace tacit {

TapeReader::TapeReader(const std::filesystem::path& file)
    : file_(file), mcap_(file), metadata_(mcap_.metadata()) {}

std::string TapeReader::fact(std::string_view group, const std::string& key) const {
  for (const mcap::Metadata& metadata : metadata_) {
    const auto found = metadata.values.find(key);
    if (metadata.name == group && found != metadata.values.end()) return found->second;
  }
  return "";
}

/// Calls `take(word)` for each message of the topic's channel.
template <class Topic, class Take>
void TapeReader::each(Take&& take) const {
  const std::string topic = '/' + topic_name<Topic>();
  const auto channel = mcap_.channel(topic);
  if (!channel) throw McapError(file_, "holds no channel " + topic + ", wanted a run of Tacit's");
  const auto schema = mcap_.schemas().find(mcap_.channels().at(*channel).schema);
  if (schema == mcap_.schemas().end() || schema->second.text != schema_of<Topic>().text) {
    throw McapError(file_, topic + " is of another version of Tacit's");
  }
  typename Topic::Word word;
  mcap_.read([&](const mcap::Message& message) {
    if (message.channel != *channel) return;
    if (const Flaw flaw = from_cdr(message.data, word)) {
      throw McapError(file_, "a message of " + topic + ": " + std::string(flaw.what));
    }
    take(word);
  });
}

void TapeReader::events(const std::function<void(const Event&)>& take) const {
  std::uint64_t next = 0;
  each<topics::Events>([&](const EventBatch& batch) {
    if (batch.first > next) throw McapError(file_, "event " + std::to_string(next) + " is missing");
    for (std::uint64_t i = next - batch.first; i < batch.events.size(); ++i) {
      take(batch.events[i]);
      ++next;
    }
  });
}

void TapeReader::views(const std::function<void(const WorldView&)>& take) const {
  each<topics::WorldView>(take);
}

}  // namespace tacit
