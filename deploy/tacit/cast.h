#pragma once

#include <cstdint>
#include <vector>

#include "console/record/run_directory.h"
#include "deploy/tacit/child.h"
#include "deploy/tacit/run_plan.h"

namespace tacit {

/// The programs of one run over DDS.
struct Cast {
  Program world;
  Program console;
  std::vector<Program> agents;  ///< In order of id.
};

/// Where on the bus a run takes place.
struct Venue {
  int domain = 1;
  std::uint32_t run_nonce = 0;
};

/// The programs of `plan`, which take their scenario from `directory` and log there.
[[nodiscard]] Cast cast_for(const RunPlan& plan, const RunDirectory& directory, Venue venue);

}  // namespace tacit
