#pragma once

#include <filesystem>
#include <vector>

#include "wizard_service/cases/case_base.h"

namespace tacit::cbr {

/// Stores the cases of all `.cdl` files of `folder`, by the files' names, in a case base that never
/// had one; one whose cases were all removed stays empty. All or none of them. Throws as
/// `case_from` does when a file holds no case.
void seed_if_new(CaseBase& base, const std::filesystem::path& folder);

/// The cases of all `.cdl` files of `folder`, by the files' names; their origin is "seed". None
/// when there is no such folder. Throws as `case_from` does.
[[nodiscard]] std::vector<Case> seeds_in(const std::filesystem::path& folder);

/// The folder of the cases that ship: share/tacit/seed beside the folder of the program, else that
/// of the source tree.
[[nodiscard]] std::filesystem::path shipped_seeds();

/// Where a person's cases are: $XDG_DATA_HOME/tacit/cases.db, else ~/.local/share/tacit/cases.db.
/// Throws ConfigError when there is neither variable.
[[nodiscard]] std::filesystem::path usual_case_file();

}  // namespace tacit::cbr
