#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "console/gateway/session.h"
#include "idl/types/roster.h"

namespace tacit {

/// What a call of an operator's service means: "pause", "resume", "step" with `ticks`, "speed" with
/// `factor`, "stop", "proceed" and "skip_goal" with `robot`, "steer" with `robot`, `x` and `y`,
/// "let_go" with `robot`. Robot 0, or none, is the whole team. Throws ConfigError with what was
/// found and what was wanted.
[[nodiscard]] Control control_of(std::string_view service, std::string_view request_json);

/// Offers all of them; `say` is called on the gateway's thread.
void add_operator_services(gateway::Session& session, std::function<void(const Control&)> say);

}  // namespace tacit
