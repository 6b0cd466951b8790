#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <thread>

#include "deploy/experiment/preview.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/crew_line.h"
#include "deploy/tacit/operation_options.h"
#include "deploy/tacit/operation_wish.h"
#include "deploy/tacit/preview_text.h"
#include "deploy/tacit/until_interrupted.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit preview biohazard.cdl --map office.ovl
  tacit preview my.cdl --map office7.ovl --robots 2 --extra sentry.cdl --flights 100 --jobs 4
  tacit preview eod.cdl --map minefield.ovl --set noise.sight_rad=0.02 --json

The mission is carried out --flights times in this process, as `tacit run --one-process` does with
the seeds S, S+1, …; the result is the same for any number of --jobs. Ctrl-C gives up the flights
under way and tells what the others came to.

Exit codes: 0 done, 1 the machine failed, 2 bad input, 130 interrupted.)";

struct PreviewCommand {
  RunWish run;
  std::size_t flights = PreviewWish().flights;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};

Setup operation_of(const RunWish& wish) {
  if (!asks_for_mission(wish)) {
    throw ConfigError("found " + wish.scenario + ", wanted a mission (.cdl)");
  }
  return resolve(wish);
}

Exit make_preview(const PreviewCommand& command) {
  const RunWish& wish = command.run;
  const Setup setup = operation_of(wish);
  CrewLine line("flights", wish.quiet);
  Preview made;
  (void)until_interrupted([&](const std::stop_token& stop) {
    made = preview(setup, {seed(setup), command.flights},
                   {command.jobs, [&line](const CrewProgress& p) { line.show(p); }}, stop);
  });
  line.finish();
  const PreviewFacts facts{wish.scenario, wish.map, wish.extra, seed(setup)};
  std::cout << (wish.json ? preview_json(made, facts) + '\n' : preview_text(made, facts))
            << std::flush;
  return made.cut_short() ? Exit::Interrupted : Exit::Done;
}

void add_preview_options(CLI::App& command, PreviewCommand& wish) {
  command.add_option("mission", wish.run.scenario, "A mission (.cdl)")->required();
  command.add_option("--robots", wish.run.robots, "Size of the team")->type_name("N");
  add_operation_options(command, wish.run);
  command
      .add_option("--duration", wish.run.duration_s, "Simulated time of a flight at most [3600]")
      ->type_name("S");
  command.add_option("--flights", wish.flights, "How often it is carried out")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, kMostFlights))
      ->capture_default_str();
  command.add_option("--seed", wish.run.seed, "Of the first flight; the next has the next [1]")
      ->type_name("S");
  command.add_option("--jobs", wish.jobs, "Flights at once")
      ->type_name("N")
      ->check(CLI::Range(1U, 1024U))
      ->capture_default_str();
  command.add_flag("--json", wish.run.json, "Print one JSON object with the result, nothing else");
  command.add_flag("--quiet", wish.run.quiet, "No progress");
}

}  // namespace

void add_preview(CLI::App& app, Exit& ending) {
  CLI::App* command =
      app.add_subcommand("preview", "Tell what a mission is likely to come to, from many flights");
  const auto wish = std::make_shared<PreviewCommand>();
  add_preview_options(*command, *wish);
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = make_preview(*wish); });
}

}  // namespace tacit
