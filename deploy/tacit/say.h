#pragma once

#include <string_view>

namespace tacit {

/// One line for people, on standard error: "tacit: ...". Standard output is for results.
void say(std::string_view text);

}  // namespace tacit
