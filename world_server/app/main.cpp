#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>

#include "idl/types/config_error.h"
#include "world_server/app/options.h"
#include "world_server/app/server.h"

namespace tacit {
namespace {

constexpr std::chrono::milliseconds kDefaultPatience{1000};

std::optional<std::chrono::milliseconds> patience(const Options& options) {
  if (options.patience_ms) {
    return *options.patience_ms > 0 ? std::optional(std::chrono::milliseconds(*options.patience_ms))
                                    : std::nullopt;
  }
  return options.speed > 0.0 ? std::optional(kDefaultPatience) : std::nullopt;
}

Server::Settings settings(const Options& options) {
  Server::Settings settings;
  settings.identity = {Party::World, {}, options.domain, options.run_nonce, 0};
  settings.speed = options.speed;
  settings.patience = patience(options);
  settings.gather = std::chrono::duration<double>(options.gather_s);
  settings.view_hz = options.view_hz;
  settings.trajectories =
      options.trajectories ? Gallery::Trajectories::On : Gallery::Trajectories::Off;
  settings.await_console = options.await_console;
  return settings;
}

ExitCode run(const Options& options) {
  try {
    const Mission mission = read_mission(options.scenario, options.duration_s);
    return Server(mission, settings(options)).run();
  } catch (const ConfigError& error) {
    spdlog::error("{}", error.what());
    return ExitCode::BadInput;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return ExitCode::Failed;
  }
}

}  // namespace
}  // namespace tacit

int main(int argc, char** argv) {
  const auto options = tacit::read_options(argc, argv);
  if (const int* code = std::get_if<int>(&options)) return *code;
  spdlog::set_default_logger(spdlog::stderr_logger_mt("world_server"));
  std::signal(SIGPIPE, SIG_IGN);
  return static_cast<int>(tacit::run(std::get<tacit::Options>(options)));
}
