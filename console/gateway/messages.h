#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "console/gateway/outbox.h"
#include "console/gateway/session.h"

/// What the server says in the Foxglove WebSocket protocol, v1.
namespace tacit::gateway::messages {

using Json = nlohmann::ordered_json;

struct ParameterValue {
  Json value;
  std::string type;
};

[[nodiscard]] Frame server_info(std::string_view name, std::string_view session);
[[nodiscard]] Json channel(ChannelId id, const Channel& channel);
[[nodiscard]] Frame advertise(Json channels);
[[nodiscard]] Frame unadvertise(ChannelId id);
[[nodiscard]] Json service(ServiceId id, const Service& service);
[[nodiscard]] Frame advertise_services(Json services);
[[nodiscard]] Frame unadvertise_service(ServiceId id);
[[nodiscard]] Frame service_response(ServiceId id, std::uint32_t call, std::string_view json);
[[nodiscard]] Frame service_failure(ServiceId id, std::uint32_t call, std::string_view message);
[[nodiscard]] Frame message_data(std::uint32_t subscription, std::uint64_t log_time_ns,
                                 Payload bytes);
[[nodiscard]] Frame time(std::uint64_t time_ns);
/// `id` is the client's for the question, or null.
[[nodiscard]] Frame parameter_values(const std::map<std::string, ParameterValue>& values,
                                     const Json& id);
[[nodiscard]] Frame status(StatusLevel level, std::string_view message, std::string_view id);
[[nodiscard]] Frame remove_status(std::string_view id);
/// What turns one graph into the other.
[[nodiscard]] Frame graph_update(const ConnectionGraph& before, const ConnectionGraph& after);

}  // namespace tacit::gateway::messages
