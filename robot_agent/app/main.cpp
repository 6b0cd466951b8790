#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>

#include "idl/types/config_error.h"
#include "robot_agent/app/agent.h"
#include "robot_agent/app/options.h"

namespace tacit {
namespace {

ExitCode run(const Options& options) {
  try {
    const Soldier soldier = read_soldier(options.scenario);
    return Agent(soldier, {{options.id},
                           options.domain,
                           options.run_nonce,
                           options.memory,
                           options.inherit,
                           options.learned,
                           std::chrono::duration<double>(options.patience_s)})
        .run();
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
  spdlog::set_default_logger(spdlog::stderr_logger_mt("robot_agent"));
  std::signal(SIGPIPE, SIG_IGN);
  return static_cast<int>(tacit::run(std::get<tacit::Options>(options)));
}
