#pragma once

#include <string>
#include <string_view>

#include "idl/types/parameters.h"

namespace tacit {

/// The shortest decimal that reads back to the same bits; always with a point or an exponent, so
/// that TOML takes it for a float.
[[nodiscard]] std::string toml_number(double value);

/// `value` as a TOML basic string, quotes included.
[[nodiscard]] std::string toml_string(std::string_view value);

/// "0 to 5", "at least 0", "at most 5", or nothing when every number will do.
[[nodiscard]] std::string words(const Range& range);

}  // namespace tacit
