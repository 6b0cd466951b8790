#include "deploy/tacit/wizard_link.h"

#include <chrono>
#include <csignal>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "console/record/temporary_folder.h"
#include "deploy/tacit/child.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/scenario_library.h"
#include "idl/bus/domain_lease.h"
#include "idl/bus/wizard_post.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr milliseconds kStopPatience{3000};
/// The exit code of a wizard that found something wrong with its input.
constexpr int kBadInput = 2;

}  // namespace

fs::path wizard_program() { return program_folder() / "wizard_service"; }

/// A wizard of this process alone, on a domain that nobody else has.
class WizardLink::Own {
 public:
  explicit Own(const std::string& cases)
      : folder_("tacit-wizard"),
        log_(folder_.path() / "wizard.log"),
        lease_(DomainLease::take(kWizardNonce)),
        child_(program(cases)) {}
  ~Own() {
    child_.send(SIGTERM);
    const auto until = std::chrono::steady_clock::now() + kStopPatience;
    while (!child_.reap() && child_.running() && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(milliseconds(5));
    }
  }
  Own(const Own&) = delete;
  Own& operator=(const Own&) = delete;

  [[nodiscard]] int domain() const { return lease_.domain(); }

  void throw_if_dead() {
    const std::optional<Death> death = child_.reap();
    if (!death) return;
    const std::string text = "the wizard " + death->words() + ": " + last_lines(log_, 1);
    if (death->exit_code == kBadInput) throw ConfigError(text);
    throw std::runtime_error(text);
  }

 private:
  [[nodiscard]] Program program(const std::string& cases) const {
    std::vector<std::string> arguments{"--domain", std::to_string(lease_.domain())};
    if (!cases.empty()) {
      arguments.insert(arguments.end(), {"--cases", fs::absolute(cases).string()});
    }
    return {"wizard_service", wizard_program(), std::move(arguments), log_};
  }

  TemporaryFolder folder_;
  fs::path log_;
  DomainLease lease_;
  Child child_;
};

WizardLink::WizardLink(const WizardWish& wish, Signals& signals) : signals_(signals) {
  int domain = wish.domain;
  if (!wish.cases.empty() || !WizardPost::is_held(wish.domain)) {
    own_ = std::make_unique<Own>(wish.cases);
    domain = own_->domain();
  }
  const auto patience = std::chrono::duration<double>(wish.patience_s);
  client_ = std::make_unique<WizardClient>(
      WizardClient::Settings{domain, std::chrono::duration_cast<milliseconds>(patience)});
}

WizardLink::~WizardLink() {
  client_.reset();
  own_.reset();
}

WizardClient::Reply WizardLink::ask(WizardClient::What what) {
  const auto tell = [](const WizardProgress& progress) {
    say("the wizard is at " + std::to_string(static_cast<int>(progress.done * 100.0)) +
        " %: " + progress.doing);
  };
  const auto cancelled = [this] {
    signals_.wait(milliseconds(0));
    if (own_ && !signals_.end_wanted()) own_->throw_if_dead();
    return signals_.end_wanted();
  };
  return client_->ask(std::move(what), tell, cancelled);
}

}  // namespace tacit
