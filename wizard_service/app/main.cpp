#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "idl/bus/participant.h"
#include "idl/types/config_error.h"
#include "wizard_service/app/options.h"
#include "wizard_service/app/service.h"
#include "wizard_service/cases/seed.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

/// As many as can work at once, within reason: each knows all cases.
std::size_t desks() { return std::clamp(std::thread::hardware_concurrency(), 1U, 4U); }

fs::path seeds_of(const WizardOptions& options) {
  if (options.seeds.empty()) return cbr::shipped_seeds();
  if (fs::is_directory(options.seeds)) return options.seeds;
  throw ConfigError("--seeds: found no directory " + options.seeds);
}

WizardExit run(const WizardOptions& options) {
  try {
    const fs::path file = options.cases.empty() ? cbr::usual_case_file() : fs::path(options.cases);
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    std::vector<std::unique_ptr<cbr::CaseBase>> bases;
    bases.push_back(std::make_unique<cbr::CaseBase>(file));
    cbr::seed_if_new(*bases.front(), seeds_of(options));
    const std::uint64_t cases = bases.front()->size();
    while (bases.size() < desks()) bases.push_back(std::make_unique<cbr::CaseBase>(file));
    WizardService service(std::move(bases), options.domain);
    spdlog::info("answers on domain {} from {} cases in {}", options.domain, cases, file.string());
    service.run();
    return WizardExit::Done;
  } catch (const ConfigError& error) {
    spdlog::error("{}", error.what());
    return WizardExit::BadInput;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return WizardExit::Failed;
  }
}

}  // namespace
}  // namespace tacit

int main(int argc, char** argv) {
  const auto options = tacit::read_wizard_options(argc, argv);
  if (const int* code = std::get_if<int>(&options)) return *code;
  spdlog::set_default_logger(spdlog::stderr_logger_mt("wizard"));
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return static_cast<int>(tacit::run(std::get<tacit::WizardOptions>(options)));
}
