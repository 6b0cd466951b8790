#include "idl/scenario/values.h"

#include <array>
#include <charconv>
#include <cmath>

namespace tacit {
namespace {

/// Plain digits where people read them with ease, powers of ten beyond.
std::string shortest(double value) {
  std::array<char, 32> digits{};
  const double size = std::fabs(value);
  const bool plain = value == 0.0 || (size >= 1e-6 && size < 1e16);
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 plain ? std::chars_format::fixed : std::chars_format::scientific);
  return {digits.data(), end.ptr};
}

constexpr std::string_view kHex = "0123456789ABCDEF";

std::string escaped(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (c == '"' || c == '\\') {
    return {'\\', c};
  }
  if (byte >= 0x20 && byte != 0x7f) {
    return {c};
  }
  return {'\\', 'u', '0', '0', kHex[byte >> 4U], kHex[byte & 15U]};
}

}  // namespace

std::string toml_number(double value) {
  std::string text = shortest(value);
  if (std::isfinite(value) && text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  return text;
}

std::string toml_string(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    text += escaped(c);
  }
  return text + '"';
}

std::string words(const Range& range) {
  const bool below = std::isfinite(range.min);
  const bool above = std::isfinite(range.max);
  if (below && above) {
    return shortest(range.min) + " to " + shortest(range.max);
  }
  if (below) {
    return "at least " + shortest(range.min);
  }
  return above ? "at most " + shortest(range.max) : "";
}

}  // namespace tacit
