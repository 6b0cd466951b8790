#include "idl/scenario/document.h"

#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "idl/scenario/values.h"
#include "idl/types/config_error.h"
#include "idl/types/nearest_word.h"

namespace tacit {
namespace {

std::string place(const toml::source_region& source, const std::string& path) {
  if (source.begin.line == 0) {
    return path;
  }
  return path + ':' + std::to_string(source.begin.line) + ':' + std::to_string(source.begin.column);
}

toml::table parsed(std::string_view text, const std::string& path) {
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw ConfigError(place(error.source(), path) + ": " + std::string(error.description()));
  }
}

/// The value that `text` spells, or `text` itself for words without quotes.
toml::table parsed_value(std::string_view text) {
  try {
    return toml::parse("value = " + std::string(text));
  } catch (const toml::parse_error&) {
    toml::table word;
    word.insert("value", std::string(text));
    return word;
  }
}

std::optional<std::vector<double>> row(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr) {
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const toml::node& number : *list) {
    if (!number.is_number()) {
      return std::nullopt;
    }
    numbers.push_back(*number.value<double>());
  }
  return numbers;
}

std::optional<Rows> rows(const toml::array& list) {
  Rows all;
  for (const toml::node& node : list) {
    std::optional<std::vector<double>> numbers = row(node);
    if (!numbers) {
      return std::nullopt;
    }
    all.push_back(std::move(*numbers));
  }
  return all;
}

std::optional<Texts> texts(const toml::array& list) {
  Texts all;
  for (const toml::node& node : list) {
    const auto* text = node.as_string();
    if (text == nullptr) {
      return std::nullopt;
    }
    all.push_back(text->get());
  }
  return all;
}

FoundValue found_list(const toml::array& list, std::string where) {
  if (std::optional<Rows> numbers = rows(list)) {
    return {std::move(*numbers), "a list of rows", std::move(where)};
  }
  if (std::optional<Texts> all = texts(list)) {
    return {std::move(*all), "a list of texts", std::move(where)};
  }
  return {std::monostate{}, "a list", std::move(where)};
}

FoundValue found(const toml::node& node, std::string where) {
  if (const auto* whole = node.as_integer()) {
    return {whole->get(), std::to_string(whole->get()), std::move(where)};
  }
  if (const auto* number = node.as_floating_point()) {
    return {number->get(), toml_number(number->get()), std::move(where)};
  }
  if (const auto* flag = node.as_boolean()) {
    return {flag->get(), flag->get() ? "true" : "false", std::move(where)};
  }
  if (const auto* word = node.as_string()) {
    return {word->get(), toml_string(word->get()), std::move(where)};
  }
  if (const auto* list = node.as_array()) {
    return found_list(*list, std::move(where));
  }
  return {std::monostate{}, node.is_table() ? "a table" : "a date or time", std::move(where)};
}

/// A value from elsewhere than the file.
struct StandIn {
  toml::table value;
  std::string giver;
};

std::string section_of(const std::string& path) { return path.substr(0, path.rfind('.')); }
std::string key_of(const std::string& path) { return path.substr(path.rfind('.') + 1); }

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

class Document::Tree {
 public:
  Tree(toml::table root, std::string path) : root_(std::move(root)), path_(std::move(path)) {}

  [[nodiscard]] std::optional<FoundValue> find(const std::string& section,
                                               const std::string& key) const {
    const auto stand_in = stand_ins.find(section + '.' + key);
    if (stand_in != stand_ins.end()) {
      return found(*stand_in->second.value.get("value"), stand_in->second.giver);
    }
    const toml::table* table = root_.at_path(section).as_table();
    const toml::node* node = table != nullptr ? table->get(key) : nullptr;
    return node != nullptr ? std::optional(found(*node, place(node->source(), path_)))
                           : std::nullopt;
  }

  [[nodiscard]] bool has(std::string_view section) const {
    return root_.at_path(section).is_table();
  }

  [[nodiscard]] Given given(const std::string& path) const {
    if (stand_ins.contains(path)) return Given::Set;
    const toml::table* table = root_.at_path(section_of(path)).as_table();
    return table != nullptr && table->contains(key_of(path)) ? Given::File : Given::Nobody;
  }

  [[nodiscard]] const std::string& name() const { return path_; }

  void refuse_unknown_keys() const {
    for (const auto& [section, keys] : known) {
      if (const toml::table* table = root_.at_path(section).as_table()) {
        refuse_unknown_keys(*table, section);
      }
    }
    for (const auto& [path, stand_in] : stand_ins) {
      if (known.contains(section_of(path))) {
        require_key(stand_in.giver, section_of(path), key_of(path));
      }
    }
  }

  void refuse_unknown_sections() const {
    refuse_unknown_tables(root_, "");
    for (const auto& [path, stand_in] : stand_ins) {
      require_section(stand_in.giver, section_of(path));
    }
  }

  std::map<std::string, StandIn> stand_ins;               ///< By path.
  std::map<std::string, std::vector<std::string>> known;  ///< Keys by section.

 private:
  void refuse_unknown_keys(const toml::table& table, const std::string& section) const {
    for (const auto& [key, node] : table) {
      if (!node.is_table()) {
        require_key(place(key.source(), path_), section, std::string(key.str()));
      }
    }
  }

  void require_key(const std::string& where, const std::string& section,
                   const std::string& key) const {
    const std::vector<std::string>& keys = known.at(section);
    if (!contains(keys, key)) {
      throw ConfigError(where + ": [" + section + "] has no key \"" + key + '"' +
                        did_you_mean(key, keys));
    }
  }

  /// Tables lie in tables, as deep as a person has typed.
  // NOLINTNEXTLINE(misc-no-recursion)
  void refuse_unknown_tables(const toml::table& table, const std::string& prefix) const {
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      if (const toml::table* inner = node.as_table()) {
        require_section(place(key.source(), path_), name);
        refuse_unknown_tables(*inner, name + '.');
      } else if (prefix.empty()) {
        throw ConfigError(place(key.source(), path_) + ": \"" + name +
                          "\" stands outside the sections, wanted it below a [section]");
      }
    }
  }

  /// Known itself, or the way to one that is.
  void require_section(const std::string& where, const std::string& section) const {
    std::vector<std::string> names;
    for (const auto& [name, keys] : known) {
      if (name == section || name.starts_with(section + '.')) {
        return;
      }
      names.push_back(name);
    }
    throw ConfigError(where + ": there is no section [" + section + ']' +
                      did_you_mean(section, names));
  }

  toml::table root_;
  std::string path_;
};

Document::Document(std::string_view text, const std::string& path)
    : tree_(std::make_unique<Tree>(parsed(text, path), path)) {}
Document::~Document() = default;

void Document::set(std::string_view path, std::string_view text, std::string_view giver) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == path.size()) {
    throw ConfigError(std::string(giver) + ": found \"" + std::string(path) +
                      "\", wanted section.key=value");
  }
  tree_->stand_ins.insert_or_assign(std::string(path),
                                    StandIn{parsed_value(text), std::string(giver)});
}

bool Document::has(std::string_view section) const { return tree_->has(section); }

Given Document::given(const std::string& path) const { return tree_->given(path); }

const std::string& Document::name() const { return tree_->name(); }

void Document::open(std::string_view section) { tree_->known[std::string(section)]; }

std::optional<FoundValue> Document::find(const std::string& section, std::string_view key) {
  tree_->known[section].emplace_back(key);
  return tree_->find(section, std::string(key));
}

void Document::refuse_unknown_keys() const { tree_->refuse_unknown_keys(); }
void Document::refuse_unknown_sections() const { tree_->refuse_unknown_sections(); }

}  // namespace tacit
