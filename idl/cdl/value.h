#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tacit::cdl {

/// `{}`.
struct NoValue {
  friend bool operator==(const NoValue&, const NoValue&) = default;
};
/// `{Mines | Robots}`; also a single word.
struct Words {
  std::vector<std::string> words;
  friend bool operator==(const Words&, const Words&) = default;
};
/// `{"any text"}`, without its quotation marks, its escapes as written.
struct QuotedText {
  std::string text;
  friend bool operator==(const QuotedText&, const QuotedText&) = default;
};
/// `{^}` or `{^Type %name}`: the value of the parameter of the same or of the given name, as
/// offered by what is around.
struct FromAbove {
  std::string type;
  std::string name;
  friend bool operator==(const FromAbove&, const FromAbove&) = default;
};

/// A number, a list of two or more numbers (a point has two), a flag, words, text.
using Value =
    std::variant<NoValue, double, std::vector<double>, bool, Words, QuotedText, FromAbove>;

/// What stands between the braces. Whatever is none of the others is a single word.
[[nodiscard]] Value parse_value(std::string_view text);

/// "a number", "2 numbers", "a flag", …
[[nodiscard]] std::string describe(const Value& value);

}  // namespace tacit::cdl
