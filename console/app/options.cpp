#include "console/app/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "console/app/exit_code.h"
#include "idl/topics/topics.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

constexpr const char* kAbout =
    "Records a run: collects its events, folds its metrics, writes its run directory and shows how "
    "it goes, on standard error.";
constexpr const char* kExitCodes =
    "Exit codes: 0 the whole run is recorded, 1 it could not be recorded, 2 bad input, 4 the world "
    "has vanished, 130 interrupted or stopped.";

void add_run_options(CLI::App& app, Options& options, std::string& nonce) {
  app.add_option("--scenario", options.scenario, "The scenario as resolved, in TOML")
      ->check(CLI::ExistingFile);
  app.add_option("--out", options.out, "Run directory, new or empty")->required();
  app.add_option("--store", options.store, "SQLite file that gets a row for this run");
  app.add_option("--domain", options.domain, "DDS domain of the run")
      ->required()
      ->check(CLI::Range(0, 232));
  app.add_option("--run-nonce", nonce, "Tells this run from others, up to 8 hexadecimal digits")
      ->required()
      ->check([](const std::string& text) -> std::string {
        const bool hex = text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
        return hex && !text.empty() && text.size() <= 8 ? "" : "wanted 1 to 8 hexadecimal digits";
      });
  app.add_option("--key", options.key, "Under which the store keeps the run; else one is made up");
  app.add_option(
         "--command-line", options.command_line,
         "One word of the command to be noted as this run's, as --command-line=WORD; may be "
         "repeated")
      ->expected(1)
      ->take_all();
}

void add_other_options(CLI::App& app, Options& options) {
  app.add_flag("--resume", options.resume,
               "Go on with the run directory of a console that died in this run");
  app.add_flag("--trajectories", options.trajectories, "Record every body at every tick");
  app.add_option("--record", options.tape,
                 "MCAP file in which to record what the run tells people; one that is there is "
                 "kept under another name");
  app.add_flag("--quiet", options.quiet, "Show neither progress nor the final metrics");
  app.add_option("--patience", options.patience_s,
                 "Seconds without a word from the world after which it has vanished")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.set_version_flag("--version", "console " + std::string(version()));
  app.add_flag_callback(
      "--interface",
      [] {
        std::cout << interface_text(Party::Console);
        throw CLI::Success();
      },
      "Show the topics it reads and writes");
}

}  // namespace

std::variant<Options, int> read_options(int argc, char** argv) {
  CLI::App app(kAbout, "console");
  app.footer(kExitCodes);
  Options options;
  std::string nonce;
  add_run_options(app, options, nonce);
  add_other_options(app, options);
  try {
    app.parse(argc, argv);
    if (options.resume == !options.scenario.empty()) {
      throw CLI::ValidationError("console", "wanted either --scenario or --resume");
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? static_cast<int>(ExitCode::Done)
                                : static_cast<int>(ExitCode::BadInput);
  }
  options.run_nonce = static_cast<std::uint32_t>(std::stoul(nonce, nullptr, 16));
  if (options.command_line.empty()) {
    options.command_line.assign(argv, argv + argc);
  }
  return options;
}

}  // namespace tacit
