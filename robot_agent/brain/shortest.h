#pragma once

#include <array>
#include <charconv>
#include <string>

namespace tacit {

/// The shortest decimal text that reads back to the same bits.
[[nodiscard]] inline std::string shortest(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

}  // namespace tacit
