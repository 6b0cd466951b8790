#pragma once

#include <optional>
#include <string>

#include "console/debrief/checklist.h"
#include "console/record/run_directory.h"

namespace tacit {

/// What `--json` prints: one object with scenario, seed, version, transport, ticks, wall_s,
/// ticks_per_s, event_log_sha256, metrics, run_dir, complete, repeatable and, of an operation,
/// checklist. Without the newline.
[[nodiscard]] std::string summary_json(const RunDirectory& directory, const RunOutcome& outcome,
                                       const std::optional<Checklist>& checklist);

/// What else people are told below the table: length, speed, hash and place.
[[nodiscard]] std::string summary_text(const RunDirectory& directory, const RunOutcome& outcome);

}  // namespace tacit
