#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "idl/overlay/finding.h"

namespace tacit {

/// A word of a map.
struct MapToken {
  enum class Kind : std::uint8_t { Word, Quoted, Number };
  Kind kind = Kind::Word;
  std::string_view text;  ///< Without quotes.
  double number = 0.0;
  MapSpot at;
  std::size_t begin = 0;  ///< In the whole text, quotes included.
  std::size_t end = 0;
};

/// Thrown and caught in this library: one statement cannot be read.
struct MapRefusal {
  MapFinding finding;
};

/// An error at `token`: found it, wanted `wanted`.
[[nodiscard]] MapRefusal refusal(const MapToken& token, std::string_view wanted);

/// Appends the words of one line, which goes from `begin` to `end` of `text`. Blanks, commas and
/// carriage returns part words; "--" outside quotes begins a comment. A quote that is not closed
/// ends with its line; its place is returned.
std::optional<MapSpot> add_tokens(std::string_view text, std::size_t begin, std::size_t end,
                                  std::uint32_t line, std::vector<MapToken>& tokens);

/// In capitals (ASCII).
[[nodiscard]] std::string capitals(std::string_view text);

/// A finite number: sign, digits, point, exponent, nothing else.
[[nodiscard]] std::optional<double> map_number(std::string_view text);

}  // namespace tacit
