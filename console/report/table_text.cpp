#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "console/report/table.h"

namespace tacit {
namespace {

constexpr const char* kAbsent = "–";

std::string rounded(double number, int decimals) {
  if (!std::isfinite(number)) {
    return kAbsent;
  }
  std::array<char, 400> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  return {digits.data(), end};
}

struct Words {
  int decimals;

  std::string operator()(std::monostate) const { return kAbsent; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(std::int64_t count) const { return std::to_string(count); }
  std::string operator()(double measure) const { return rounded(measure, decimals); }
  std::string operator()(const Estimate& e) const {
    return rounded(e.value, decimals) + " [" + rounded(e.low, decimals) + ", " +
           rounded(e.high, decimals) + ']';
  }
};

/// In characters; UTF-8's continuation bytes take no place.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

using Lines = std::vector<std::vector<std::string>>;

Lines lines_of(const Table& table) {
  Lines lines(1);
  for (const Column& column : table.columns) {
    lines.front().push_back(column.title);
  }
  for (const auto& row : table.rows) {
    auto& line = lines.emplace_back();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      line.push_back(std::visit(Words{table.columns[i].decimals}, row.at(i)));
    }
  }
  return lines;
}

/// Words stand to the left, figures to the right.
bool is_words(const Table& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
    return std::holds_alternative<std::string>(row.at(column));
  });
}

void pad_column(Lines& lines, std::size_t column, bool to_left) {
  std::size_t widest = 0;
  for (const auto& line : lines) {
    widest = std::max(widest, width(line[column]));
  }
  for (auto& line : lines) {
    std::string& text = line[column];
    text.insert(to_left ? text.size() : 0, widest - width(text), ' ');
  }
}

}  // namespace

std::string to_text(const Table& table) {
  Lines lines = lines_of(table);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    pad_column(lines, i, is_words(table, i));
  }
  std::string out = table.title.empty() ? "" : table.title + '\n';
  for (const auto& line : lines) {
    std::string text;
    for (const std::string& field : line) {
      text += (text.empty() ? "" : "  ") + field;
    }
    out += text.substr(0, text.find_last_not_of(' ') + 1) + '\n';
  }
  return out;
}

}  // namespace tacit
