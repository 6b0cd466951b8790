#include "console/server/console_server.h"

#include <system_error>

#include "console/server/api.h"
#include "idl/types/config_error.h"

namespace tacit {

namespace fs = std::filesystem;

class ConsoleServer::Impl {
 public:
  explicit Impl(const ConsoleServerConfig& config) : api_(config) {
    std::error_code error;
    fs::create_directories(config.runs, error);
    if (!fs::is_directory(config.runs)) {
      throw ConfigError(config.runs.string() + ": cannot be made, wanted a folder for runs");
    }
    api_.worker = std::make_unique<Worker>();
    api_.wizard = std::make_unique<WizardDesk>(config.programs / "wizard_service",
                                               api_.scratch / "wizard", config.cases);
    api_.live = std::make_unique<LiveRuns>(api_.server, api_.runs);
    add_run_routes(api_);
    add_library_routes(api_);
    add_plan_routes(api_);
    add_health_routes(api_);
    api_.server.start();
  }
  ~Impl() {
    api_.server.stop();
    api_.live.reset();
    api_.worker.reset();
    api_.wizard.reset();
    api_.replays.clear();
    api_.previews.clear();
    api_.run_jobs.clear();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] std::string url() const { return api_.server.url(); }

 private:
  Api api_;
};

ConsoleServer::ConsoleServer(const ConsoleServerConfig& config)
    : impl_(std::make_unique<Impl>(config)) {}
ConsoleServer::~ConsoleServer() = default;

std::string ConsoleServer::url() const { return impl_->url(); }

}  // namespace tacit
