#pragma once

#include <string_view>

#include "idl/cdl/finding.h"
#include "idl/cdl/model.h"

namespace tacit::cdl {

/// Lists and rules in each other: deeper is refused, so that no file can exhaust the stack.
inline constexpr int kDeepest = 200;
/// Errors after which the rest is not read.
inline constexpr std::size_t kMostErrors = 50;

struct Parsed {
  Mission mission;    ///< The statements without error.
  Findings findings;  ///< Errors alone, by their place.
};

/// Reads a mission. A statement with an error is left out and the next one read.
///
/// Takes time in proportion to the text, whatever the text. Bytes from 128 on, of UTF-8, Latin-1 or
/// anything else, are kept as they are in descriptions, comments and values and refused elsewhere.
/// NUL is refused. A byte order mark of UTF-8 at the front is passed over.
[[nodiscard]] Parsed parse(std::string_view text);

}  // namespace tacit::cdl
