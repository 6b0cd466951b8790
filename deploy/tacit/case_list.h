#pragma once

#include <span>
#include <string>

#include "console/report/table.h"
#include "wizard_service/cases/case_base.h"

namespace tacit {

/// A row for each case, for people.
[[nodiscard]] Table case_table(std::span<const cbr::Case> cases);

/// A list of objects with `id`, `title`, `origin`, `features` and `record`, an object each. Without
/// the newline.
[[nodiscard]] std::string cases_json(std::span<const cbr::Case> cases);
/// A list of objects with `id` and `reason`. Without the newline.
[[nodiscard]] std::string flaws_json(std::span<const cbr::Flaw> flaws);

/// "9.5 of 10 good, 3 uses"; empty when nothing has been learned.
[[nodiscard]] std::string record_line(const cbr::TrackRecord& record);

/// A name for a file that holds the case: "12_two_robots_assess_a_building.cdl".
[[nodiscard]] std::string case_file_name(const cbr::Case& one);

}  // namespace tacit
