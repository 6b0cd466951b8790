#pragma once

#include <CLI/CLI.hpp>

#include "deploy/tacit/run_plan.h"

namespace tacit {

/// Adds the options that say on which map, beside whom and from where a mission is carried out, and
/// which parameters are other than usual: --map, --extra, --extra-colour, --start, --extra-start
/// and --set. They fill `wish`, which outlives `command`.
void add_operation_options(CLI::App& command, RunWish& wish);

}  // namespace tacit
