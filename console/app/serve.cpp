#include "console/app/serve.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>

#include "console/app/exit_code.h"
#include "console/app/stop_signals.h"
#include "console/gateway/server.h"
#include "console/server/console_server.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAbout =
    "Serves the page for people who watch and plan, a REST interface, and the Foxglove WebSocket "
    "protocol, on one port.";
constexpr const char* kExitCodes =
    "Ends at SIGINT or SIGTERM; runs that it has started go on. Exit codes: 0 ended, 1 the port "
    "could not be had or the machine failed, 2 bad input.";

ConsoleServerConfig with_defaults(ConsoleServerConfig config) {
  config.programs = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path shared = config.programs.parent_path() / "share/tacit";
  const fs::path source = TACIT_SOURCE_FOLDER;
  config.maps = {shared / "maps", source / "deploy/maps"};
  config.missions = {shared / "missions", source / "deploy/missions"};
  config.scenarios = {shared / "scenarios", source / "deploy/scenarios"};
  if (config.pages.empty()) {
    const fs::path installed = shared / "web";
    config.pages = fs::is_directory(installed) ? installed : source / "console/web/dist";
  }
  if (config.runs.empty()) config.runs = "runs";
  config.runs = fs::absolute(config.runs);
  return config;
}

ExitCode run(const ConsoleServerConfig& config) {
  Bell bell;
  const StopSignals signals(bell);
  ConsoleServer server(config);
  // For people and for programs that look for the address; all else goes to standard error.
  std::cout << server.url() << std::endl;
  spdlog::info("runs in {}; Ctrl-C ends", config.runs.string());
  while (!StopSignals::came()) bell.wait_until(Bell::Clock::now() + std::chrono::seconds(1));
  return ExitCode::Done;
}

}  // namespace

int serve(int argc, char** argv) {
  CLI::App app(kAbout, "console serve");
  ConsoleServerConfig config;
  app.add_option("--port", config.port, "0 for any that is free")
      ->type_name("N")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  app.add_option("--address", config.address,
                 "To listen on; beyond this machine a token is needed, which is told")
      ->capture_default_str();
  app.add_option("--token", config.token, "Needed by whoever comes [made up beyond this machine]");
  app.add_option("--origin", config.origins,
                 "A page of another server that may open sockets, as in https://app.foxglove.dev")
      ->type_name("ORIGIN");
  app.add_option("--runs", config.runs, "Folder of run directories [runs]")->type_name("DIR");
  app.add_option("--cases", config.cases, "Case base of the wizard [its own]")->type_name("FILE");
  app.add_option("--pages", config.pages, "Folder of the page [as built]")->type_name("DIR");
  app.footer(kExitCodes);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return static_cast<int>(app.exit(error) == 0 ? ExitCode::Done : ExitCode::BadInput);
  }
  spdlog::set_default_logger(spdlog::stderr_logger_mt("console"));
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return static_cast<int>(run(with_defaults(std::move(config))));
  } catch (const ConfigError& error) {
    spdlog::error("{}", error.what());
    return static_cast<int>(ExitCode::BadInput);
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return static_cast<int>(ExitCode::NotRecorded);
  }
}

}  // namespace tacit
