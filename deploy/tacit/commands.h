#pragma once

#include <CLI/CLI.hpp>

#include "deploy/tacit/exit_codes.h"

namespace tacit {

/// Each adds one command to the command line. What it does runs while the command line is parsed
/// and leaves its ending in `ending`, which outlives `app`. A ConfigError passes through.
void add_run(CLI::App& app, Exit& ending);
void add_learn(CLI::App& app, Exit& ending);
void add_experiment(CLI::App& app, Exit& ending);
void add_scenarios(CLI::App& app, Exit& ending);
void add_console(CLI::App& app, Exit& ending);
void add_plan(CLI::App& app, Exit& ending);
void add_wizard(CLI::App& app, Exit& ending);
void add_policy(CLI::App& app, Exit& ending);
void add_mission(CLI::App& app, Exit& ending);
void add_cases(CLI::App& app, Exit& ending);
void add_map(CLI::App& app, Exit& ending);
void add_scene(CLI::App& app, Exit& ending);
void add_watch(CLI::App& app, Exit& ending);
void add_operate(CLI::App& app, Exit& ending);
void add_preview(CLI::App& app, Exit& ending);
void add_replay(CLI::App& app, Exit& ending);
void add_verify(CLI::App& app, Exit& ending);
void add_debrief(CLI::App& app, Exit& ending);
void add_doctor(CLI::App& app, Exit& ending);

/// `tacit experiment wizard`, a sub-command of `experiment`.
void add_wizard_study(CLI::App& experiment, Exit& ending);

}  // namespace tacit
