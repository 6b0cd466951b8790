#pragma once

#include <array>
#include <span>
#include <string_view>

#include "idl/overlay/overlay.h"
#include "idl/overlay/tokens.h"

namespace tacit {

/// How a shape is written: keyword, name, points, at times a last number.
struct ShapeForm {
  std::string_view keyword;
  ShapeKind kind;
  std::size_t fewest_points;
  std::size_t most_points;
};

/// How a header is written.
struct HeaderForm {
  std::string_view keyword;
  HeaderKind kind;
  bool quoted;  ///< Its words stand in quotes.
  std::size_t fewest_words;
  std::size_t most_words;
  std::size_t fewest_numbers;
  std::size_t most_numbers;
};

[[nodiscard]] const ShapeForm& form_of(ShapeKind kind);
[[nodiscard]] const HeaderForm& form_of(HeaderKind kind);

/// What the words of one statement, at least one, mean; `MapUnknown` when its keyword is none.
/// Throws MapRefusal.
[[nodiscard]] MapContent content_of(std::span<const MapToken> tokens);

/// The keyword that a person who typed `typed` most likely meant; empty when none is near.
[[nodiscard]] std::string_view nearest_keyword(std::string_view typed);

}  // namespace tacit
