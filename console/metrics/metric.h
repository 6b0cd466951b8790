#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

namespace tacit {

/// One figure of a run, ready to be printed.
struct Metric {
  std::string_view key;   ///< Unique within a tally; ends with the unit when there is one.
  std::string_view unit;  ///< Empty for a count.
  std::string_view doc;   ///< One sentence.
  /// A count or a measure; absent when the run gave nothing to measure.
  std::optional<std::variant<std::uint64_t, double>> value;
};

/// A measure that may be absent, as a metric's value.
[[nodiscard]] inline decltype(Metric::value) measured(const std::optional<double>& measure) {
  return measure ? decltype(Metric::value){*measure} : std::nullopt;
}

}  // namespace tacit
