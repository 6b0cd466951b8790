#include "idl/cdl/value.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace tacit::cdl {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(trimmed(text.substr(at, end - at)));
    at = end + 1;
  }
  return parts;
}

std::optional<double> number(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  double read = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, read);
  const bool finite =
      !text.empty() &&
      (std::isdigit(static_cast<unsigned char>(text.back())) != 0 || text.back() == '.');
  return error == std::errc() && stop == end && finite ? std::optional(read) : std::nullopt;
}

std::optional<Value> numbers(std::string_view text) {
  std::vector<double> list;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> one = number(part);
    if (!one) {
      return std::nullopt;
    }
    list.push_back(*one);
  }
  return list.size() == 1 ? Value(list.front()) : Value(std::move(list));
}

FromAbove from_above(std::string_view text) {
  const std::size_t percent = text.find('%');
  const bool named = percent != std::string_view::npos;
  return {std::string(trimmed(text.substr(0, percent))),
          named ? std::string(trimmed(text.substr(percent + 1))) : ""};
}

}  // namespace

Value parse_value(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) {
    return NoValue{};
  }
  if (text.front() == '^') {
    return from_above(text.substr(1));
  }
  if (text.size() > 1 && text.front() == '"' && text.find('"', 1) == text.size() - 1) {
    return QuotedText{std::string(text.substr(1, text.size() - 2))};
  }
  if (text == "true" || text == "false") {
    return text == "true";
  }
  if (std::optional<Value> read = numbers(text)) {
    return *std::move(read);
  }
  Words words;
  for (const std::string_view word : split(text, '|')) {
    words.words.emplace_back(word);
  }
  return words;
}

std::string describe(const Value& value) {
  struct Names {
    std::string operator()(const NoValue&) const { return "nothing"; }
    std::string operator()(double) const { return "a number"; }
    std::string operator()(const std::vector<double>& list) const {
      return std::to_string(list.size()) + " numbers";
    }
    std::string operator()(bool) const { return "true or false"; }
    std::string operator()(const Words& words) const {
      return words.words.size() == 1 ? "a word" : "several words";
    }
    std::string operator()(const QuotedText&) const { return "a text"; }
    std::string operator()(const FromAbove&) const { return "a value from above"; }
  };
  return std::visit(Names{}, value);
}

}  // namespace tacit::cdl
