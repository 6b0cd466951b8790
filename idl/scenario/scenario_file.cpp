#include "idl/scenario/scenario_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "idl/scenario/document.h"
#include "idl/scenario/values.h"
#include "idl/types/config_error.h"
#include "idl/types/nearest_word.h"

namespace tacit {
namespace {

/// "a number", "a whole number of 1 to 1000", "a number of at least 0 (m)", ...
std::string wish(std::string what, const Range& range, const ParameterDoc& doc) {
  const std::string bounds = words(range);
  what += bounds.empty() ? "" : " of " + bounds;
  return doc.unit.empty() ? what : what + " (" + std::string(doc.unit) + ')';
}

std::string wish(std::span<const std::string_view> choices, const std::string& typed) {
  std::string text;
  for (const std::string_view choice : choices) {
    text += (text.empty() ? "one of " : ", ") + toml_string(choice);
  }
  const std::vector<std::string> known(choices.begin(), choices.end());
  return text + did_you_mean(typed, known);
}

/// A whole number will do where a number is wanted.
std::optional<double> as_number(const FoundValue& found) {
  if (const auto* number = std::get_if<double>(&found.value)) {
    return *number;
  }
  const auto* whole = std::get_if<std::int64_t>(&found.value);
  return whole != nullptr ? std::optional(static_cast<double>(*whole)) : std::nullopt;
}

bool within(double value, const Range& range) {
  return std::isfinite(value) && value >= range.min && value <= range.max;
}

std::string wish_rows(std::span<const std::string_view> columns, const Range& range,
                      const ParameterDoc& doc) {
  std::string text = "rows of " + std::to_string(columns.size()) + " numbers [";
  for (const std::string_view column : columns) {
    text += (column.data() == columns.front().data() ? "" : ", ") + std::string(column);
  }
  return wish(text + ']', range, doc);
}

/// The number, from 1, of the first row that does not have `columns` numbers within `range`.
std::optional<std::size_t> bad_row(const Rows& rows, std::size_t columns, const Range& range) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool good = rows[i].size() == columns &&
                      std::all_of(rows[i].begin(), rows[i].end(),
                                  [&range](double value) { return within(value, range); });
    if (!good) {
      return i + 1;
    }
  }
  return std::nullopt;
}

/// Gives each visited parameter the document's value.
class Filler final : public ParameterVisitor {
 public:
  explicit Filler(Document& document) : document_(document) {}

  void section(std::string_view name, std::string_view /*doc*/) override {
    section_ = name;
    document_.open(name);
  }

  void number(std::string_view key, double& value, Range range, ParameterDoc doc) override {
    if (const auto found = document_.find(section_, key)) {
      const std::optional<double> number = as_number(*found);
      require(number && within(*number, range), *found, key, wish("a number", range, doc));
      value = *number;
    }
  }

  void integer(std::string_view key, std::int64_t& value, Range range, ParameterDoc doc) override {
    if (const auto found = document_.find(section_, key)) {
      const auto* whole = std::get_if<std::int64_t>(&found->value);
      require(whole != nullptr && within(static_cast<double>(*whole), range), *found, key,
              wish("a whole number", range, doc));
      value = *whole;
    }
  }

  void flag(std::string_view key, bool& value, ParameterDoc /*doc*/) override {
    if (const auto found = document_.find(section_, key)) {
      const auto* flag = std::get_if<bool>(&found->value);
      require(flag != nullptr, *found, key, "true or false");
      value = *flag;
    }
  }

  void choice(std::string_view key, std::string& value, std::span<const std::string_view> choices,
              ParameterDoc /*doc*/) override {
    if (const auto found = document_.find(section_, key)) {
      const auto* word = std::get_if<std::string>(&found->value);
      const bool known =
          word != nullptr && std::find(choices.begin(), choices.end(), *word) != choices.end();
      require(known, *found, key, wish(choices, word != nullptr ? *word : ""));
      value = *word;
    }
  }

  void rows(std::string_view key, Rows& value, std::span<const std::string_view> columns,
            Range range, ParameterDoc doc) override {
    if (auto found = document_.find(section_, key)) {
      auto* rows = std::get_if<Rows>(&found->value);
      const auto bad = rows != nullptr ? bad_row(*rows, columns.size(), range) : std::nullopt;
      if (bad) {
        found->spelled += " whose row " + std::to_string(*bad) + " does not fit";
      }
      require(rows != nullptr && !bad, *found, key, wish_rows(columns, range, doc));
      value = std::move(*rows);
    }
  }

  void text(std::string_view key, std::string& value, ParameterDoc /*doc*/) override {
    if (const auto found = document_.find(section_, key)) {
      const auto* text = std::get_if<std::string>(&found->value);
      require(text != nullptr, *found, key, "text in quotes");
      value = *text;
    }
  }

  void texts(std::string_view key, Texts& value, ParameterDoc /*doc*/) override {
    if (auto found = document_.find(section_, key)) {
      const auto* rows = std::get_if<Rows>(&found->value);
      auto* texts = std::get_if<Texts>(&found->value);
      require(texts != nullptr || (rows != nullptr && rows->empty()), *found, key,
              "a list of texts in quotes");
      value = texts != nullptr ? std::move(*texts) : Texts{};
    }
  }

 private:
  void require(bool good, const FoundValue& found, std::string_view key,
               const std::string& wanted) const {
    if (!good) {
      throw ConfigError(found.where + ": [" + section_ + "] " + std::string(key) + " = " +
                        found.spelled + ": found " + found.spelled + ", wanted " + wanted);
    }
  }

  Document& document_;
  std::string section_;
};

}  // namespace

ScenarioFile::ScenarioFile(std::unique_ptr<Document> document) : document_(std::move(document)) {}
ScenarioFile::~ScenarioFile() = default;
ScenarioFile::ScenarioFile(ScenarioFile&&) noexcept = default;
ScenarioFile& ScenarioFile::operator=(ScenarioFile&&) noexcept = default;

ScenarioFile ScenarioFile::read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !in) {
    throw ConfigError(path.string() + ": cannot be read, wanted a scenario file (TOML)");
  }
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return parse(text, path.string());
}

ScenarioFile ScenarioFile::parse(std::string_view text, const std::string& path) {
  return ScenarioFile(std::make_unique<Document>(text, path));
}

void ScenarioFile::set(std::string_view path, std::string_view text, std::string_view giver) {
  document_->set(path, text, giver);
}

bool ScenarioFile::has(std::string_view section) const { return document_->has(section); }

Given ScenarioFile::given(const std::string& path) const { return document_->given(path); }

const std::string& ScenarioFile::name() const { return document_->name(); }

void ScenarioFile::fill(const Describe& describe_all) {
  Filler filler(*document_);
  describe_all(filler);
  document_->refuse_unknown_keys();
}

void ScenarioFile::refuse_unknown_sections() const { document_->refuse_unknown_sections(); }

}  // namespace tacit
