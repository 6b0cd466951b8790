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

/// The same for JSON, whose readers take "-0" for a whole number without a sign.
[[nodiscard]] inline std::string json_number(double value) {
  std::string text = shortest(value);
  return text == "-0" ? "-0.0" : text;
}

}  // namespace tacit
