#pragma once

#include <optional>
#include <string>

#include "console/debrief/checklist.h"
#include "console/record/run_directory.h"

namespace tacit {

/// What became of a recorded operation, from its scenario and its event log; of one that is under
/// way or was cut short, as far as its log goes. None when the run is no operation. Throws
/// ConfigError when a file is missing or makes no sense, naming it.
[[nodiscard]] std::optional<Checklist> debrief_of(const RunDirectory& directory);

/// For people: the score, then a line for each sub-task. Without the last newline.
[[nodiscard]] std::string checklist_text(const Checklist& list);

/// One object with `done`, `wanted` and `tasks`, a list of objects with `name`, `done` and
/// `evidence`. Without the newline.
[[nodiscard]] std::string checklist_json(const Checklist& list);

}  // namespace tacit
