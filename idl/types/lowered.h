#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace tacit {

/// `text` with small letters for capitals; ASCII alone has any.
[[nodiscard]] inline std::string lowered(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

}  // namespace tacit
