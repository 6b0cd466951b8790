#include "console/report/table.h"

#include <array>
#include <charconv>
#include <cmath>

namespace tacit {
namespace {

/// The shortest form that reads back to the same bits; nothing for what is no number.
template <class Number>
std::string in_full(Number number) {
  if (!std::isfinite(static_cast<double>(number))) {
    return "";
  }
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + '"';
}

struct CsvFields {
  bool intervals;

  std::string operator()(std::monostate) const { return intervals ? ",," : ""; }
  std::string operator()(const std::string& text) const { return csv_text(text) + rest(); }
  std::string operator()(std::int64_t count) const { return in_full(count) + rest(); }
  std::string operator()(double measure) const { return in_full(measure) + rest(); }
  std::string operator()(const Estimate& e) const {
    return in_full(e.value) + (intervals ? ',' + in_full(e.low) + ',' + in_full(e.high) : "");
  }

 private:
  [[nodiscard]] const char* rest() const { return intervals ? ",," : ""; }
};

std::string json_text(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted.append(1, '\\').append(1, c);
    } else if (code < 0x20U) {
      quoted.append("\\u00").append(1, kHex[code >> 4U]).append(1, kHex[code & 15U]);
    } else {
      quoted.append(1, c);
    }
  }
  return quoted + '"';
}

struct JsonValue {
  std::string operator()(std::monostate) const { return "null"; }
  std::string operator()(const std::string& text) const { return json_text(text); }
  std::string operator()(std::int64_t count) const { return in_full(count); }
  /// JSON has no infinity and no NaN.
  std::string operator()(double measure) const {
    const std::string digits = in_full(measure);
    return digits.empty() ? "null" : digits;
  }
  std::string operator()(const Estimate& e) const {
    const JsonValue& self = *this;
    return "{\"value\": " + self(e.value) + ", \"low\": " + self(e.low) +
           ", \"high\": " + self(e.high) + '}';
  }
};

std::string json_row(const Table& table, const std::vector<TableCell>& row) {
  std::string members;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    members += (i == 0 ? "" : ", ") + json_text(table.columns[i].key) + ": " +
               std::visit(JsonValue{}, row.at(i));
  }
  return '{' + members + '}';
}

}  // namespace

std::string to_csv(const Table& table) {
  std::string out;
  for (const Column& column : table.columns) {
    out += (out.empty() ? "" : ",") + csv_text(column.key);
    if (column.intervals) {
      out += ',' + csv_text(column.key + "_low") + ',' + csv_text(column.key + "_high");
    }
  }
  out += "\r\n";
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      out += (i == 0 ? "" : ",") + std::visit(CsvFields{table.columns[i].intervals}, row.at(i));
    }
    out += "\r\n";
  }
  return out;
}

std::string to_json(const Table& table) {
  std::string rows;
  for (const auto& row : table.rows) {
    rows += (rows.empty() ? "\n    " : ",\n    ") + json_row(table, row);
  }
  return "{\n  \"title\": " + json_text(table.title) + ",\n  \"rows\": [" + rows +
         (rows.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

}  // namespace tacit
