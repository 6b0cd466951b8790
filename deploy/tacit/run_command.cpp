#include <CLI/CLI.hpp>
#include <memory>

#include "deploy/tacit/commands.h"
#include "deploy/tacit/make_run.h"
#include "deploy/tacit/operation_options.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit run guard --robots 6 --learner lm --strategy 1 --seed 7
  tacit run guard --one-process --json
  tacit run guard --map building.ovl
  tacit run biohazard.cdl --map office.ovl --extra sentry.cdl
  tacit run forage --robots 6 --learner q --policy policies/team
  tacit run my.toml --set enemies.speed_mps=1.5 --out runs/slow --trajectories

Exit codes: 0 done, 1 the machine failed, 2 bad input, 3 an agent or the world was lost,
4 time-out, 130 interrupted.)";

double read_speed(const std::string& text) {
  if (text == "max") {
    return 0.0;
  }
  std::size_t read = 0;
  double speed = 0.0;
  try {
    speed = std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  if (read != text.size() || !(speed > 0.0 && speed <= 1e6)) {
    throw ConfigError("--speed: found \"" + text +
                      "\", wanted max or a number above 0, at most 1000000");
  }
  return speed;
}

void add_scenario_options(CLI::App& run, RunWish& wish) {
  run.add_option("scenario", wish.scenario,
                 "Name of a scenario, or a file: a scenario (.toml) or a mission (.cdl)")
      ->capture_default_str();
  run.add_option("--robots", wish.robots, "Size of the team")->type_name("N");
  run.add_option("--learner", wish.learner,
                 "guard: static1, static2, lm or crowd; forage: q, homogeneous or heterogeneous")
      ->type_name("NAME");
  run.add_option("--strategy", wish.strategy, "Attack strategy 1 to 5; 0 for no enemies")
      ->type_name("N");
  run.add_option("--seed", wish.seed, "Seed of every stream of chance")->type_name("N");
  run.add_option("--duration", wish.duration_s, "Simulated time of the run")->type_name("S");
  add_operation_options(run, wish);
}

void add_run_options(CLI::App& run, RunWish& wish, std::string& speed) {
  run.add_flag("--one-process", wish.one_process, "The same team in one process, without DDS");
  run.add_option("--speed", speed, "max, or times real time")
      ->type_name("X")
      ->capture_default_str();
  run.add_option("--out", wish.out, "Run directory; new or empty [runs/SCENARIO-SEED-TIME]")
      ->type_name("DIR");
  run.add_option("--store", wish.store, "Run store that gets a row [runs.db beside DIR]")
      ->type_name("FILE");
  run.add_option("--policy", wish.policy,
                 "Folder of policies: the robots begin with what is there and keep there what they "
                 "learn")
      ->type_name("DIR");
  run.add_option("--record", wish.record_file,
                 "Record what the run tells people as an MCAP file, for `tacit replay`, Foxglove "
                 "and others [run.mcap in DIR]")
      ->type_name("FILE")
      ->expected(0, 1);
  run.add_flag("--trajectories", wish.trajectories, "Record where every body was, tick by tick");
  run.add_flag("--profile", wish.profile, "Tell where the time went (with --one-process)");
  run.add_option("--timeout", wish.timeout_s, "End the run after so much wall time; 0: never")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e9));
  run.add_option("--patience-ms", wish.patience_ms,
                 "How long the world waits for an agent's command; 0: without limit [0 at full "
                 "speed, else 1000]")
      ->type_name("MS")
      ->check(CLI::Range(0, 600000));
  run.add_flag("--json", wish.json, "Print one JSON object with the result, nothing else");
  run.add_flag("--quiet", wish.quiet, "No progress");
}

Exit run(RunWish wish) {
  if (wish.profile && !wish.one_process) {
    throw ConfigError("--profile: found a run over DDS, wanted --one-process beside it");
  }
  Signals signals;
  return make_run(std::move(wish), signals).exit;
}

}  // namespace

void add_run(CLI::App& app, Exit& ending) {
  CLI::App* command = app.add_subcommand("run", "Run a scenario, over DDS or in one process");
  const auto wish = std::make_shared<RunWish>();
  const auto speed = std::make_shared<std::string>("max");
  add_scenario_options(*command, *wish);
  add_run_options(*command, *wish, *speed);
  command->footer(kExamples);
  command->callback([command, wish, speed, &ending] {
    wish->record = command->count("--record") > 0;
    wish->speed = read_speed(*speed);
    wish->command_line = words_typed();
    ending = run(*wish);
  });
}

}  // namespace tacit
