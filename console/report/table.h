#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "console/report/estimate.h"

namespace tacit {

/// A place in a table: nothing, words, a count, a measure or a measure with its interval.
using TableCell = std::variant<std::monostate, std::string, std::int64_t, double, Estimate>;

struct Column {
  std::string key;    ///< Names it in CSV and JSON, unique in its table.
  std::string title;  ///< Names it for people.
  int decimals = 1;   ///< Of measures, for people.
  /// Holds estimates: CSV gives it the further columns <key>_low and <key>_high.
  bool intervals = false;
};

/// Rows of figures, to be read by people or programs.
struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<TableCell>> rows;  ///< As long as `columns`, each.
};

/// For people: a title, aligned columns, "–" for what is absent, "value [low, high]" for an
/// estimate.
[[nodiscard]] std::string to_text(const Table& table);
/// RFC 4180, with a header line; numbers in full, an empty field for what is absent.
[[nodiscard]] std::string to_csv(const Table& table);
/// {"title": …, "rows": [{key: value, …}, …]}; numbers in full, null for what is absent, an
/// estimate as {"value": …, "low": …, "high": …}.
[[nodiscard]] std::string to_json(const Table& table);

}  // namespace tacit
