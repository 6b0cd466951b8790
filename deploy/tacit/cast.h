#pragma once

#include <cstdint>
#include <vector>

#include "console/record/run_directory.h"
#include "deploy/tacit/child.h"
#include "deploy/tacit/run_plan.h"
#include "idl/bus/venue_file.h"

namespace tacit {

/// The programs of one run over DDS.
struct Cast {
  Program world;
  Program console;
  std::vector<Program> agents;  ///< In order of id.
};

/// The programs of `plan`, which take their scenario from `directory` and log there.
[[nodiscard]] Cast cast_for(const RunPlan& plan, const RunDirectory& directory, Venue venue);

}  // namespace tacit
