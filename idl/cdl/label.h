#pragma once

#include <string>
#include <string_view>

namespace tacit::cdl {

/// What a file says, fit to be shown: UTF-8 without control characters, cut behind some 80 bytes.
/// A byte that is not of UTF-8 is taken for Latin-1, which MissionLab's files are often in.
[[nodiscard]] std::string label_of(std::string_view text);

}  // namespace tacit::cdl
