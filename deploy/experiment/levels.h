#pragma once

#include <string>
#include <vector>

namespace tacit {

/// A parameter and what it is given.
struct Setting {
  std::string path;   ///< "section.key"
  std::string value;  ///< As TOML; words may go without quotes.
  friend bool operator==(const Setting&, const Setting&) = default;
};

/// What is varied and the values it takes in turn.
struct Factor {
  std::string path;  ///< A parameter's "section.key", "scenario" or "variant".
  std::vector<std::string> values;
};

/// Parameters that are set together, under one name.
struct Variant {
  std::string name;
  std::vector<Setting> settings;
};

/// Reads "section.key = value". Throws ConfigError when it is not of that form.
[[nodiscard]] Setting read_setting(const std::string& text);
/// Reads "section.key = value, value, …". Throws ConfigError when it is not of that form.
[[nodiscard]] Factor read_factor(const std::string& text);
/// Reads "name: section.key = value; section.key = value". Throws ConfigError when it is not of
/// that form.
[[nodiscard]] Variant read_variant(const std::string& text);

}  // namespace tacit
