#include <algorithm>
#include <cstddef>
#include <vector>

#include "idl/scenario/scenario_file.h"
#include "idl/scenario/values.h"

namespace tacit {
namespace {

/// What is worth knowing of one parameter, in words.
struct Entry {
  std::string key;
  std::string value;
  std::string unit;
  std::string allowed;
  std::string doc;
};

struct Section {
  std::string name;
  std::string doc;
  std::vector<Entry> entries;
};

std::string listed(const std::vector<std::vector<double>>& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) {
    std::string numbers;
    for (const double number : row) {
      numbers += (numbers.empty() ? "" : ", ") + toml_number(number);
    }
    text += (text.empty() ? "[" : ", [") + numbers + ']';
  }
  return '[' + text + ']';
}

std::string listed(const std::vector<std::string>& texts) {
  std::string text;
  for (const std::string& one : texts) {
    text += (text.empty() ? "" : ", ") + toml_string(one);
  }
  return '[' + text + ']';
}

std::string joined(std::span<const std::string_view> words, const char* between) {
  std::string text;
  for (const std::string_view word : words) {
    text += (text.empty() ? "" : between) + std::string(word);
  }
  return text;
}

class Collector final : public ParameterVisitor {
 public:
  std::vector<Section> sections;

  void section(std::string_view name, std::string_view doc) override {
    sections.push_back({std::string(name), std::string(doc), {}});
  }
  void number(std::string_view key, double& value, Range range, ParameterDoc doc) override {
    add(key, toml_number(value), words(range), doc);
  }
  void integer(std::string_view key, std::int64_t& value, Range range, ParameterDoc doc) override {
    add(key, std::to_string(value), words(range), doc);
  }
  void flag(std::string_view key, bool& value, ParameterDoc doc) override {
    add(key, value ? "true" : "false", "true | false", doc);
  }
  void choice(std::string_view key, std::string& value, std::span<const std::string_view> choices,
              ParameterDoc doc) override {
    add(key, toml_string(value), joined(choices, " | "), doc);
  }
  void rows(std::string_view key, std::vector<std::vector<double>>& value,
            std::span<const std::string_view> columns, Range range, ParameterDoc doc) override {
    const std::string bounds = words(range);
    add(key, listed(value),
        "rows of " + joined(columns, ", ") + (bounds.empty() ? "" : ", ") + bounds, doc);
  }
  void text(std::string_view key, std::string& value, ParameterDoc doc) override {
    add(key, toml_string(value), "text", doc);
  }
  void texts(std::string_view key, std::vector<std::string>& value, ParameterDoc doc) override {
    add(key, listed(value), "texts", doc);
  }

 private:
  void add(std::string_view key, std::string value, std::string allowed, ParameterDoc doc) {
    sections.back().entries.push_back({std::string(key), std::move(value), std::string(doc.unit),
                                       std::move(allowed), std::string(doc.doc)});
  }
};

std::vector<Section> collected(const ScenarioFile::Describe& describe_all) {
  Collector collector;
  describe_all(collector);
  return collector.sections;
}

std::string comment(const Entry& entry) {
  std::string allowed = entry.allowed;
  if (!entry.unit.empty()) {
    allowed += (allowed.empty() ? "" : " ") + entry.unit;
  }
  return "# " + entry.doc + (allowed.empty() ? "" : " (" + allowed + ")");
}

/// Letters in UTF-8 text.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  }));
}

std::string padded(std::string_view text, std::size_t columns) {
  const std::size_t used = width(text);
  return std::string(text) + std::string(used < columns ? columns - used : 0, ' ');
}

constexpr std::size_t kWidest = 28;

struct Columns {
  std::size_t key = 0;
  std::size_t value = 0;
  std::size_t unit = 0;
  std::size_t allowed = 0;
};

Columns columns_of(const std::vector<Section>& sections) {
  Columns columns;
  const auto widen = [](std::size_t& column, const std::string& text) {
    column = std::max(column, std::min(width(text), kWidest));
  };
  for (const Section& section : sections) {
    for (const Entry& entry : section.entries) {
      widen(columns.key, entry.key);
      widen(columns.value, entry.value);
      widen(columns.unit, entry.unit);
      widen(columns.allowed, entry.allowed);
    }
  }
  return columns;
}

std::string aligned(const Entry& entry, const Columns& columns) {
  return "  " + padded(entry.key, columns.key) + "  " + padded(entry.value, columns.value) + "  " +
         padded(entry.unit, columns.unit) + "  " + padded(entry.allowed, columns.allowed) + "  " +
         entry.doc + '\n';
}

}  // namespace

std::string to_toml(const ScenarioFile::Describe& describe_all) {
  std::string text;
  for (const Section& section : collected(describe_all)) {
    text += (text.empty() ? "# " : "\n# ") + section.doc + "\n[" + section.name + "]\n";
    for (const Entry& entry : section.entries) {
      text += comment(entry) + '\n' + entry.key + " = " + entry.value + '\n';
    }
  }
  return text;
}

std::string explain(const ScenarioFile::Describe& describe_all) {
  const std::vector<Section> sections = collected(describe_all);
  const Columns columns = columns_of(sections);
  std::string text;
  for (const Section& section : sections) {
    text += (text.empty() ? "[" : "\n[") + section.name + "]  " + section.doc + '\n';
    for (const Entry& entry : section.entries) {
      text += aligned(entry, columns);
    }
  }
  return text;
}

}  // namespace tacit
