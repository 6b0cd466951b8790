#pragma once

#include <string>

namespace tacit {

/// This host's name, as `Hello::host` gives it.
[[nodiscard]] std::string host_name();

}  // namespace tacit
