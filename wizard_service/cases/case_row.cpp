#include "wizard_service/cases/case_row.h"

#include <array>
#include <utility>

#include "idl/types/config_error.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {
namespace {

/// In the order of the features.
constexpr std::array<const char*, kFeatures> kColumns{"task", "robots", "localization",
                                                      "environment", "handles_enemy"};

/// The smallest value of a feature's column; its code is 0.
std::int64_t lowest(Feature feature) { return feature == Feature::NumberOfRobots ? 1 : 0; }

CaseFeatures features_of(SQLite::Statement& found) {
  CaseFeatures features;
  for (const FeatureRow& row : feature_table()) {
    const char* const column = kColumns[static_cast<std::size_t>(row.feature)];
    const std::int64_t value = found.getColumn(column).getInt64();
    const std::int64_t at = value - lowest(row.feature);
    if (at < 0 || at >= static_cast<std::int64_t>(row.values.size())) {
      throw ConfigError(
          "found " + std::string(row.name) + ' ' + std::to_string(value) + ", wanted " +
          std::to_string(lowest(row.feature)) + " to " +
          std::to_string(lowest(row.feature) + static_cast<std::int64_t>(row.values.size()) - 1));
    }
    set_code(features, row.feature, static_cast<std::size_t>(at));
  }
  return features;
}

std::uint64_t count_in(SQLite::Statement& found, const char* column) {
  return static_cast<std::uint64_t>(found.getColumn(column).getInt64());
}

}  // namespace

CaseRow row_of(SQLite::Statement& found) {
  CaseRow row;
  row.one.id = count_in(found, "id");
  row.one.title = found.getColumn("title").getString();
  row.one.origin = found.getColumn("origin").getString();
  row.one.features = features_of(found);
  row.one.record.uses = static_cast<std::uint32_t>(count_in(found, "uses"));
  row.one.record.outcomes = static_cast<std::uint32_t>(count_in(found, "outcomes"));
  row.one.record.good_milli = count_in(found, "good_milli");
  row.plan = found.getColumn("plan").getString();
  row.as_written = sum_of(row.plan) == found.getColumn("plan_sum").getInt64();
  return row;
}

std::optional<std::string> flaw_of(SQLite::Statement& found) {
  try {
    const CaseRow row = row_of(found);
    if (!row.as_written) (void)plan_of(row.plan, "case " + std::to_string(row.one.id));
    return std::nullopt;
  } catch (const ConfigError& error) {
    return error.what();
  }
}

std::int64_t sum_of(std::string_view text) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return static_cast<std::int64_t>(sum);
}

void bind(SQLite::Statement& statement, const CaseFeatures& features) {
  for (const FeatureRow& row : feature_table()) {
    const std::string name = std::string(":") + kColumns[static_cast<std::size_t>(row.feature)];
    statement.bind(name,
                   static_cast<std::int64_t>(code(features, row.feature)) + lowest(row.feature));
  }
}

void bind(SQLite::Statement& statement, const TrackRecord& record) {
  statement.bind(":uses", static_cast<std::int64_t>(record.uses));
  statement.bind(":outcomes", static_cast<std::int64_t>(record.outcomes));
  statement.bind(":good_milli", static_cast<std::int64_t>(record.good_milli));
}

}  // namespace tacit::cbr
