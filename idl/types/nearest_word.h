#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tacit {

/// The word of `known` that a person who typed `typed` most likely meant; none when nothing is
/// near. The first of several equally near ones.
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view typed,
                                                      std::span<const std::string> known);

/// ", did you mean \"...\"?", or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view typed, std::span<const std::string> known);

}  // namespace tacit
