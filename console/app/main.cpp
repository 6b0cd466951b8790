#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <string_view>

#include "console/app/exit_code.h"
#include "console/app/options.h"
#include "console/app/recording.h"
#include "console/app/scenario_facts.h"
#include "console/app/serve.h"
#include "console/app/stop_signals.h"
#include "console/record/files.h"
#include "console/record/record_error.h"
#include "console/record/run_store.h"
#include "console/report/metrics_table.h"
#include "idl/types/config_error.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

void say(const std::string& text) { std::fprintf(stderr, "console: %s\n", text.c_str()); }

std::string read_scenario(const std::filesystem::path& file) {
  try {
    return read_whole_file(file);
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
}

RunDirectory new_directory(const Options& options) {
  const std::string toml = read_scenario(options.scenario);
  const ScenarioFacts scenario = scenario_facts(toml, options.scenario.string());
  RunFacts facts;
  facts.key = options.key;
  facts.version = version();
  facts.scenario = scenario.name;
  facts.seed = scenario.seed;
  facts.transport = "dds";
  facts.robots = scenario.robots;
  facts.learner = scenario.learner;
  facts.strategy = scenario.strategy;
  facts.command_line = options.command_line;
  facts.started = utc_now();
  return RunDirectory::create(options.out, facts, toml);
}

std::optional<RunStore> open_store(const Options& options) {
  if (options.store.empty()) {
    return std::nullopt;
  }
  return RunStore(options.store);
}

Identity own_identity(const Options& options) {
  Identity identity;
  identity.party = Party::Console;
  identity.domain = options.domain;
  identity.run_nonce = options.run_nonce;
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  identity.incarnation = static_cast<std::uint32_t>(::getpid()) ^ static_cast<std::uint32_t>(now);
  return identity;
}

Ending record(RunListener& listener, RunRecorder& recorder, LiveTape& tape, const Options& options,
              Bell& bell) {
  constexpr std::chrono::milliseconds kRound{200};
  const RunDirectory& directory = recorder.directory();
  const std::string scenario_file = directory.scenario_file().string();
  const double tick_s = scenario_facts(read_scenario(scenario_file), scenario_file).tick_s;
  StatusLine line(options.quiet ? StatusLine::Mode::Silent : StatusLine::fitting_mode());
  Recording recording(
      listener, recorder, tape, line,
      {options.trajectories, tick_s, std::chrono::duration<double>(options.patience_s)});
  std::optional<Ending> ending;
  while (!ending) {
    bell.wait_until(Bell::Clock::now() + kRound);
    ending = recording.round();
  }
  return *ending;
}

/// Leaves what is recorded in good order, whatever happened.
ExitCode close(RunRecorder& recorder, LiveTape& tape, std::optional<RunStore>& store,
               const Ending& ending, bool quiet) {
  if (!ending.trouble.empty()) {
    say(ending.trouble);
  }
  try {
    const RunOutcome outcome = recorder.finish(ending.wall_s, ending.trouble);
    tape.finish(outcome);
    if (!quiet) {
      std::cerr << to_text(metrics_table(recorder.tally()));
    }
    if (store) {
      store->add(recorder.row(outcome));
    }
  } catch (const RecordError& error) {
    say(error.what());
    return ExitCode::NotRecorded;
  }
  return ending.code;
}

RunListener::Views views_for(const Options& options) {
  if (options.trajectories) return RunListener::Views::EveryTick;
  return options.tape.empty() ? RunListener::Views::None : RunListener::Views::SomeTimesASecond;
}

ExitCode run(const Options& options) {
  RunRecorder recorder(
      options.resume ? RunDirectory::open(options.out) : new_directory(options),
      options.trajectories ? RunRecorder::Trajectories::On : RunRecorder::Trajectories::Off);
  auto store = open_store(options);
  LiveTape tape =
      options.tape.empty() ? LiveTape() : LiveTape(options.tape, recorder.directory(), say);
  Bell bell;
  const StopSignals signals(bell);
  RunListener listener(own_identity(options), recorder.directory().facts().robots,
                       views_for(options), bell);
  const Ending ending = record(listener, recorder, tape, options, bell);
  return close(recorder, tape, store, ending, options.quiet);
}

ExitCode guarded_run(const Options& options) {
  // A file that may not grow further is an error to be told, not a reason to die.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(options);
  } catch (const ConfigError& error) {
    say(error.what());
    return ExitCode::BadInput;
  } catch (const std::exception& error) {
    say(error.what());
    return ExitCode::NotRecorded;
  }
}

}  // namespace
}  // namespace tacit

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "serve") return tacit::serve(argc - 1, argv + 1);
  const auto options = tacit::read_options(argc, argv);
  if (const int* code = std::get_if<int>(&options)) {
    return *code;
  }
  return static_cast<int>(tacit::guarded_run(std::get<tacit::Options>(options)));
}
