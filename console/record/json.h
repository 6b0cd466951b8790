#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "console/record/run.h"

namespace tacit {

/// Records as JSON objects, keys in a fixed order, numbers in the shortest form that reads back to
/// the same bits. Reading throws ConfigError "where: key: found ..., wanted ..."; `where` names the
/// text. Keys that are not known are passed over.
[[nodiscard]] std::string to_json(const RunFacts& facts);
[[nodiscard]] std::string to_json(const RunOutcome& outcome);
[[nodiscard]] std::string to_json(const std::vector<RecordedMetric>& metrics);

[[nodiscard]] RunFacts facts_from_json(std::string_view text, const std::string& where);
[[nodiscard]] RunOutcome outcome_from_json(std::string_view text, const std::string& where);
[[nodiscard]] std::vector<RecordedMetric> metrics_from_json(std::string_view text,
                                                            const std::string& where);

}  // namespace tacit
