#pragma once

#include <string>

#include "deploy/experiment/preview.h"

namespace tacit {

/// What was flown.
struct PreviewFacts {
  std::string mission;
  std::string map;
  std::string extra;  ///< May be empty.
  std::uint64_t seed = 1;
};

/// For people: how often all was done, the mean score, the median time, and what failed.
[[nodiscard]] std::string preview_text(const Preview& preview, const PreviewFacts& facts);

/// One object with `version`, `mission`, `map`, `extra`, `seed`, `wanted`, `flown`, `cut_short`,
/// `alike`;/// `success`, `score` and `time_s`, each an object with `value`, `low` and `high`, or
/// null where there are too few flights; `weaknesses` and `flights`. Without the newline.
[[nodiscard]] std::string preview_json(const Preview& preview, const PreviewFacts& facts);

}  // namespace tacit
