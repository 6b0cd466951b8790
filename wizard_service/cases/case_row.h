#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "wizard_service/cbr/case.h"

namespace tacit::cbr {

/// A row of the table of cases: a case without its plan and failures, and the plan's text.
struct CaseRow {
  Case one;
  std::string plan;
  bool as_written = false;  ///< The plan's text is what was once written for a plan.
};

/// Of a statement that selects all columns and stands on a row. Throws ConfigError when a feature
/// has no such value.
[[nodiscard]] CaseRow row_of(SQLite::Statement& found);

/// Why the row of an id cannot be used; none when it can.
[[nodiscard]] std::optional<std::string> flaw_of(SQLite::Statement& found);

/// Equal for equal texts, and hardly ever for others: FNV-1a.
[[nodiscard]] std::int64_t sum_of(std::string_view text);

/// Features by their column's name with a colon in front.
void bind(SQLite::Statement& statement, const CaseFeatures& features);
void bind(SQLite::Statement& statement, const TrackRecord& record);

}  // namespace tacit::cbr
