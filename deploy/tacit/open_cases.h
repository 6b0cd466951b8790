#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "wizard_service/cases/case_base.h"

namespace tacit {

/// Which case base a person means.
struct CaseFileWish {
  std::string file;   ///< Empty: the person's own.
  std::string seeds;  ///< Folder of the cases that a new one begins with; empty: those that ship.
};

/// Opens it, or makes a new one and says so. Throws ConfigError when it, its folder or a folder of
/// seeds that was asked for is none, CaseBaseError when it cannot be read or written.
[[nodiscard]] std::unique_ptr<cbr::CaseBase> open_cases(const CaseFileWish& wish);

}  // namespace tacit
