#pragma once

#include <string>
#include <string_view>

#include "idl/cdl/model.h"

namespace tacit::cdl {

/// In the house layout: one item a line, indented by its depth, comments before what they stood
/// before. `parse` gives the same mission back.
[[nodiscard]] std::string print(const Mission& mission);

/// A mission that `source` was parsed to and that may have been edited since. What was not edited
/// keeps its text, byte for byte; what was edited or added is in the house layout. All of it is
/// when comments stand so that this cannot be: `parse` gives the same mission back, in either case.
[[nodiscard]] std::string print(const Mission& mission, std::string_view source);

}  // namespace tacit::cdl
