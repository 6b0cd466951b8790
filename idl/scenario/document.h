#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "idl/scenario/given.h"

namespace tacit {

using Rows = std::vector<std::vector<double>>;
using Texts = std::vector<std::string>;

/// A value as the file gives it.
struct FoundValue {
  /// Empty for what no parameter takes: a table, a date, a list of anything but rows of numbers or
  /// texts; an empty list counts as one without rows.
  std::variant<std::monostate, std::int64_t, double, bool, std::string, Rows, Texts> value;
  std::string spelled;  ///< On one line, for messages.
  std::string where;    ///< "file:line:col" or who set it.
};

/// A TOML text, the values that stand in for its own, and what has been asked of it so far.
class Document {
 public:
  /// Throws ConfigError when `text` is not TOML; `path` is its name in messages.
  Document(std::string_view text, const std::string& path);
  ~Document();

  /// As ScenarioFile::set.
  void set(std::string_view path, std::string_view text, std::string_view giver);
  /// As ScenarioFile::has.
  [[nodiscard]] bool has(std::string_view section) const;

  /// As ScenarioFile::given.
  [[nodiscard]] Given given(const std::string& path) const;
  /// Its name in messages.
  [[nodiscard]] const std::string& name() const;

  /// From here on `section` is known.
  void open(std::string_view section);
  /// The value of `key`, which from here on is known.
  [[nodiscard]] std::optional<FoundValue> find(const std::string& section, std::string_view key);

  /// Throws ConfigError when a known section holds an unknown key.
  void refuse_unknown_keys() const;
  /// Throws ConfigError when there is an unknown section.
  void refuse_unknown_sections() const;

 private:
  class Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace tacit
