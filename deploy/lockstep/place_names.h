#pragma once

#include <string>
#include <string_view>

#include "idl/overlay/plan.h"

namespace tacit {

/// The mission `text` with the places of `plan` for the names of its points wherever a goal is
/// given by one word; all else stays as it is, byte for byte. `name` is the text's in errors.
/// Throws ConfigError when the text is no mission or a name is not a point's.
[[nodiscard]] std::string with_places(const std::string& text, std::string_view name,
                                      const MapPlan& plan);

/// The mission `text` for so many robots: the last ones left out, or the last one again.
[[nodiscard]] std::string with_robots(const std::string& text, std::string_view name,
                                      std::size_t robots);

}  // namespace tacit
