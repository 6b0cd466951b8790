#include "world_server/app/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "idl/topics/topics.h"
#include "idl/version/version.h"
#include "world_server/app/exit_code.h"

namespace tacit {
namespace {

constexpr const char* kAbout =
    "The world of one run: gathers the agents of a scenario, then sends each robot its percepts, "
    "collects its commands and moves the world on, tick by tick.";
constexpr const char* kExitCodes =
    "Exit codes: 0 the run is over, 1 the bus could not be set up, 2 bad input, 3 every agent is "
    "gone, 4 the agents did not all come in time, 130 interrupted or stopped.";

std::string check_nonce(const std::string& text) {
  const bool hex = text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
  return hex && !text.empty() && text.size() <= 8 ? "" : "wanted 1 to 8 hexadecimal digits";
}

std::string check_speed(const std::string& text) {
  double speed = 0.0;
  const bool good =
      text == "max" || (CLI::detail::lexical_cast(text, speed) && speed > 0.0 && speed <= 1e6);
  return good ? "" : "wanted max or a number above 0 and up to 1e6, found " + text;
}

void add_run_options(CLI::App& app, Options& options, std::string& nonce) {
  app.add_option("--scenario", options.scenario, "The scenario, in TOML")->required();
  app.add_option("--domain", options.domain, "DDS domain of the run")
      ->required()
      ->check(CLI::Range(1, 100));
  app.add_option("--run-nonce", nonce, "Tells this run from others, up to 8 hexadecimal digits")
      ->required()
      ->check(check_nonce);
  app.add_option("--duration", options.duration_s, "Simulated seconds, in place of the scenario's")
      ->check(CLI::Range(1e-9, 31557600.0));
  app.add_option("--gather", options.gather_s,
                 "Seconds in which all agents must come, and in which one must come back when all "
                 "are gone")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  app.add_flag("--await-console", options.await_console,
               "Begin only when somebody listens to the event log");
}

void add_pace_options(CLI::App& app, Options& options, std::string& speed) {
  app.add_option("--speed", speed, "Times real time, or max")
      ->check(check_speed)
      ->capture_default_str();
  app.add_option("--patience-ms", options.patience_ms,
                 "How long a tick waits for a command before its robot stands still for it; 0 "
                 "without end. Without end at speed max, else 1000, when not given")
      ->check(CLI::Range(0, 3600000));
  app.add_option("--view-hz", options.view_hz, "World views a second for those who watch")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  app.add_flag("--trajectories", options.trajectories, "Send every body at every tick");
}

void add_words(CLI::App& app) {
  app.footer(kExitCodes);
  app.set_version_flag("--version", "world_server " + std::string(version()));
  app.add_flag_callback(
      "--interface",
      [] {
        std::cout << interface_text(Party::World);
        throw CLI::Success();
      },
      "Show the topics it reads and writes");
}

}  // namespace

std::variant<Options, int> read_options(int argc, char** argv) {
  CLI::App app(kAbout, "world_server");
  Options options;
  std::string nonce;
  std::string speed = "max";
  add_run_options(app, options, nonce);
  add_pace_options(app, options, speed);
  add_words(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? static_cast<int>(ExitCode::Done)
                                : static_cast<int>(ExitCode::BadInput);
  }
  options.run_nonce = static_cast<std::uint32_t>(std::stoul(nonce, nullptr, 16));
  options.speed = speed == "max" ? 0.0 : std::stod(speed);
  return options;
}

}  // namespace tacit
