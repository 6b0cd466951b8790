#pragma once

#include <string_view>

namespace tacit {

/// Which build this is: "0.1.0" of a release archive, "0.1.0+g1a2b3c4" of a checkout, with ".dirty"
/// behind it when files differ from the commit. Fit for a file name.
[[nodiscard]] std::string_view version();

}  // namespace tacit
