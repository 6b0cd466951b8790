#include "console/gateway/messages.h"

#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

namespace tacit::gateway::messages {
namespace {

static_assert(std::endian::native == std::endian::little, "the protocol is little-endian");

constexpr std::uint8_t kMessageData = 1;
constexpr std::uint8_t kTime = 2;
constexpr std::uint8_t kServiceResponse = 3;

Frame framed(const Json& json) {
  return text_frame(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// Appends a number to a frame's head.
template <typename Number>
void append(Frame& frame, Number number) {
  std::memcpy(frame.head_bytes.data() + frame.head_size, &number, sizeof number);
  frame.head_size += sizeof number;
}

template <typename Number>
void append(std::vector<std::uint8_t>& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<std::uint8_t, sizeof number>>(number);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

/// Entries of `after` that are new or differ, as [{"name": ..., KEY: [...]}]. One that went is
/// there with nobody, as long as its name is in `kept`.
Json changed(const ConnectionGraph::Ends& before, const ConnectionGraph::Ends& after,
             const char* key, const std::set<std::string>& kept) {
  Json list = Json::array();
  for (const auto& [name, ids] : after) {
    const auto old = before.find(name);
    if (old == before.end() || old->second != ids) {
      list.push_back({{"name", name}, {key, ids}});
    }
  }
  for (const auto& [name, ids] : before) {
    if (!after.contains(name) && kept.contains(name)) {
      list.push_back({{"name", name}, {key, Json::array()}});
    }
  }
  return list;
}

std::set<std::string> names(const ConnectionGraph::Ends& ends) {
  std::set<std::string> all;
  for (const auto& [name, ids] : ends) {
    all.insert(name);
  }
  return all;
}

std::set<std::string> topics(const ConnectionGraph& graph) {
  std::set<std::string> all = names(graph.publishers);
  all.merge(names(graph.subscribers));
  return all;
}

Json without(const std::set<std::string>& before, const std::set<std::string>& after) {
  Json gone = Json::array();
  for (const std::string& name : before) {
    if (!after.contains(name)) {
      gone.push_back(name);
    }
  }
  return gone;
}

/// A schema of a service; empty ones take anything.
Json half(const std::string& name, const std::string& schema) {
  return {{"encoding", "json"},
          {"schemaName", name},
          {"schemaEncoding", "jsonschema"},
          {"schema", schema.empty() ? R"({"type":"object"})" : schema}};
}

}  // namespace

Frame server_info(std::string_view name, std::string_view session) {
  return framed({{"op", "serverInfo"},
                 {"name", name},
                 {"capabilities",
                  {"time", "services", "parameters", "parametersSubscribe", "connectionGraph"}},
                 {"supportedEncodings", Json::array({"json"})},
                 {"metadata", Json::object()},
                 {"sessionId", session}});
}

Json channel(ChannelId id, const Channel& channel) {
  Json json{{"id", id},
            {"topic", channel.topic},
            {"encoding", channel.encoding},
            {"schemaName", channel.schema_name},
            {"schema", channel.schema}};
  if (!channel.schema_encoding.empty()) {
    json["schemaEncoding"] = channel.schema_encoding;
  }
  return json;
}

Frame advertise(Json channels) {
  return framed({{"op", "advertise"}, {"channels", std::move(channels)}});
}

Frame unadvertise(ChannelId id) {
  return framed({{"op", "unadvertise"}, {"channelIds", Json::array({id})}});
}

Json service(ServiceId id, const Service& service) {
  return {{"id", id},
          {"name", service.name},
          {"type", service.type},
          {"request", half(service.type + "_Request", service.request_schema)},
          {"response", half(service.type + "_Response", service.response_schema)}};
}

Frame advertise_services(Json services) {
  return framed({{"op", "advertiseServices"}, {"services", std::move(services)}});
}

Frame unadvertise_service(ServiceId id) {
  return framed({{"op", "unadvertiseServices"}, {"serviceIds", Json::array({id})}});
}

Frame service_response(ServiceId id, std::uint32_t call, std::string_view json) {
  constexpr std::string_view kEncoding = "json";
  std::vector<std::uint8_t> bytes{kServiceResponse};
  append(bytes, id);
  append(bytes, call);
  append(bytes, static_cast<std::uint32_t>(kEncoding.size()));
  bytes.insert(bytes.end(), kEncoding.begin(), kEncoding.end());
  bytes.insert(bytes.end(), json.begin(), json.end());
  return shared_frame(std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes)));
}

Frame service_failure(ServiceId id, std::uint32_t call, std::string_view message) {
  return framed(
      {{"op", "serviceCallFailure"}, {"serviceId", id}, {"callId", call}, {"message", message}});
}

Frame message_data(std::uint32_t subscription, std::uint64_t log_time_ns, Payload bytes) {
  Frame frame = shared_frame(std::move(bytes));
  append(frame, kMessageData);
  append(frame, subscription);
  append(frame, log_time_ns);
  return frame;
}

Frame time(std::uint64_t time_ns) {
  Frame frame;
  frame.binary = true;
  append(frame, kTime);
  append(frame, time_ns);
  return frame;
}

Frame parameter_values(const std::map<std::string, ParameterValue>& values, const Json& id) {
  Json list = Json::array();
  for (const auto& [name, value] : values) {
    Json one{{"name", name}, {"value", value.value}};
    if (!value.type.empty()) {
      one["type"] = value.type;
    }
    list.push_back(std::move(one));
  }
  Json json{{"op", "parameterValues"}, {"parameters", std::move(list)}};
  if (!id.is_null()) {
    json["id"] = id;
  }
  return framed(json);
}

Frame status(StatusLevel level, std::string_view message, std::string_view id) {
  Json json{{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}};
  if (!id.empty()) {
    json["id"] = id;
  }
  return framed(json);
}

Frame remove_status(std::string_view id) {
  return framed({{"op", "removeStatus"}, {"statusIds", Json::array({id})}});
}

Frame graph_update(const ConnectionGraph& before, const ConnectionGraph& after) {
  const std::set<std::string> there = topics(after);
  return framed(
      {{"op", "connectionGraphUpdate"},
       {"publishedTopics", changed(before.publishers, after.publishers, "publisherIds", there)},
       {"subscribedTopics", changed(before.subscribers, after.subscribers, "subscriberIds", there)},
       {"advertisedServices", changed(before.providers, after.providers, "providerIds", {})},
       {"removedTopics", without(topics(before), there)},
       {"removedServices", without(names(before.providers), names(after.providers))}});
}

}  // namespace tacit::gateway::messages
