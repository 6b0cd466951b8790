#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "console/gateway/session_state.h"

/// What clients say in the Foxglove WebSocket protocol, v1. What is malformed is answered with a
/// status message; nothing is thrown.
namespace tacit::gateway {

void hear_text(SessionState& session, const ClientPtr& client, std::string_view text);
void hear_binary(SessionState& session, const ClientPtr& client,
                 std::span<const std::uint8_t> bytes);

}  // namespace tacit::gateway
