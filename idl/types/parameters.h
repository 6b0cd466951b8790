#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tacit {

/// The allowed values of a number, both ends included.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// What a parameter means. `unit` is empty for a pure number; `doc` is one sentence that ends
/// with its source in brackets: [paper], [MissionLab] or [ours: reason].
struct ParameterDoc {
  std::string_view unit;
  std::string_view doc;
};

/// Walks the named parameters of a configuration struct.
///
/// Each struct is described once, by a function `describe(Config&, ParameterVisitor&)` beside it;
/// loading, checking, explaining and printing a scenario are visitors.
class ParameterVisitor {
 public:
  virtual ~ParameterVisitor() = default;

  /// Opens a group; keys visited until the next call lie in the table `[name]`.
  virtual void section(std::string_view name, std::string_view doc) = 0;
  virtual void number(std::string_view key, double& value, Range range, ParameterDoc doc) = 0;
  virtual void integer(std::string_view key, std::int64_t& value, Range range,
                       ParameterDoc doc) = 0;
  virtual void flag(std::string_view key, bool& value, ParameterDoc doc) = 0;
  /// `value` is one of `choices`.
  virtual void choice(std::string_view key, std::string& value,
                      std::span<const std::string_view> choices, ParameterDoc doc) = 0;
  /// A list of rows of numbers, one number per column, all in `range`: [[1, 2, 3], [4, 5, 6]].
  virtual void rows(std::string_view key, std::vector<std::vector<double>>& value,
                    std::span<const std::string_view> columns, Range range, ParameterDoc doc) = 0;
  /// Free text for people.
  virtual void text(std::string_view key, std::string& value, ParameterDoc doc) = 0;
  /// A list of texts: ["one", "two"].
  virtual void texts(std::string_view key, std::vector<std::string>& value, ParameterDoc doc) = 0;
};

}  // namespace tacit
