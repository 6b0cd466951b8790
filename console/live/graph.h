#pragma once

#include <cstdint>

#include "console/gateway/session.h"

namespace tacit {

/// Who writes and who reads each topic of a run, robot by robot, as the bus holds them to it: no
/// topic leads from one robot to another.
[[nodiscard]] gateway::ConnectionGraph connection_graph(std::int64_t robots);

}  // namespace tacit
