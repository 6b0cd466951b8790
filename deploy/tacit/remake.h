#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "console/record/run_directory.h"
#include "idl/types/ids.h"

namespace tacit {

/// Where a recorded event log and the same run made again part.
struct Difference {
  std::uint64_t line = 0;  ///< From 1.
  Tick tick = 0;           ///< Of the event made again, or of the end of the run.
  std::string recorded;    ///< The line in the log; empty when the log is at its end.
  std::string remade;      ///< The line made again; empty when the run is over.
};

struct Remake {
  std::string sha256;  ///< Of the event log made again, whole.
  Tick ticks = 0;
  std::optional<Difference> difference;  ///< The first.
};

/// Makes the run of `directory` again in this process and compares line by line. Throws
/// ConfigError when its scenario or its event log cannot be read.
[[nodiscard]] Remake remake(const RunDirectory& directory);

}  // namespace tacit
