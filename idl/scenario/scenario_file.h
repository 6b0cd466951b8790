#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "idl/scenario/given.h"
#include "idl/types/parameters.h"

namespace tacit {

class Document;

/// A scenario in TOML: tables of parameters, each known to one `describe` function.
///
/// Every error is a ConfigError "file:line:col: [section] key = value: found ..., wanted ...";
/// a value from `set` has its giver's name in place of the file.
class ScenarioFile {
 public:
  /// Shows a visitor every parameter of one or more configuration structs.
  using Describe = std::function<void(ParameterVisitor&)>;

  /// Throws ConfigError when `path` cannot be read or is not TOML.
  [[nodiscard]] static ScenarioFile read(const std::filesystem::path& path);
  /// As `read`, from `text`; `path` is the name used in errors.
  [[nodiscard]] static ScenarioFile parse(std::string_view text, const std::string& path);

  ~ScenarioFile();
  ScenarioFile(ScenarioFile&&) noexcept;
  ScenarioFile& operator=(ScenarioFile&&) noexcept;

  /// Lets `text` stand for the value of `section.key` from the next `fill` on. `text` is a TOML
  /// value; words need no quotes; `giver` stands for the place in errors. Throws ConfigError when
  /// `path` names no section and key.
  void set(std::string_view path, std::string_view text, std::string_view giver = "--set");

  /// Whether the file itself, `set` aside, holds the table `[section]`.
  [[nodiscard]] bool has(std::string_view section) const;

  /// Who has given `section.key` its value.
  [[nodiscard]] Given given(const std::string& path) const;

  /// The file, as errors name it.
  [[nodiscard]] const std::string& name() const;

  /// Gives each parameter that the file names its value; the others keep theirs. Throws ConfigError
  /// on a wrong type, a value outside its range or choices, and a key that no parameter has.
  void fill(const Describe& describe_all);
  template <class Config>
  void fill(Config& config) {
    fill(Describe([&config](ParameterVisitor& visitor) { describe(config, visitor); }));
  }

  /// For whoever has filled all there is: throws ConfigError when the file holds, or `set` named, a
  /// section that nobody asked for.
  void refuse_unknown_sections() const;

 private:
  explicit ScenarioFile(std::unique_ptr<Document> document);
  std::unique_ptr<Document> document_;
};

/// The scenario with every parameter written out, its meaning, unit and range beside it as
/// comments. Numbers are printed in the shortest form that reads back to the same bits, so reading
/// the text and printing again gives the same text.
[[nodiscard]] std::string to_toml(const ScenarioFile::Describe& describe_all);

/// A listing for people of every parameter: key, value, unit, range and meaning, by section.
[[nodiscard]] std::string explain(const ScenarioFile::Describe& describe_all);

template <class Config>
[[nodiscard]] ScenarioFile::Describe describing(Config& config) {
  return [&config](ParameterVisitor& visitor) { describe(config, visitor); };
}

}  // namespace tacit
