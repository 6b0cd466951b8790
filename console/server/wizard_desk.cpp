#include "console/server/wizard_desk.h"

#include <chrono>
#include <utility>

#include "idl/bus/domain_lease.h"
#include "idl/bus/wizard_post.h"

namespace tacit {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPatience{20'000};
constexpr milliseconds kStart{10'000};

}  // namespace

class WizardDesk::Own {
 public:
  Own(const std::filesystem::path& program, const std::filesystem::path& folder,
      const std::string& cases)
      : lease_(DomainLease::take(kWizardNonce)),
        job_(words(program, cases), folder, Job::Life::EndsWithUs) {
    const auto until = std::chrono::steady_clock::now() + kStart;
    while (!WizardPost::is_held(lease_.domain()) && !job_.wait(milliseconds(10)) &&
           std::chrono::steady_clock::now() < until) {
    }
    if (!job_.running()) throw std::runtime_error("the wizard ended: " + job_.complaint());
  }
  ~Own() {
    job_.interrupt();
    job_.wait(milliseconds(2000));
  }
  Own(const Own&) = delete;
  Own& operator=(const Own&) = delete;

  [[nodiscard]] int domain() const { return lease_.domain(); }
  [[nodiscard]] bool serves() { return job_.running(); }

 private:
  [[nodiscard]] std::vector<std::string> words(const std::filesystem::path& program,
                                               const std::string& cases) const {
    std::vector<std::string> all{program.string(), "--domain", std::to_string(lease_.domain())};
    if (!cases.empty()) all.insert(all.end(), {"--cases", cases});
    return all;
  }

  DomainLease lease_;
  Job job_;
};

WizardDesk::WizardDesk(std::filesystem::path program, std::filesystem::path folder,
                       std::string cases)
    : program_(std::move(program)), folder_(std::move(folder)), cases_(std::move(cases)) {}

void WizardDesk::ask(WizardClient::What what, Take take) {
  worker_.put([this, what = std::move(what), take = std::move(take)] {
    try {
      take(answer(what));
    } catch (const std::exception& error) {
      client_.reset();
      own_.reset();
      take(WizardRefusal{error.what()});
    }
  });
}

WizardClient::Reply WizardDesk::answer(const WizardClient::What& what) {
  find_wizard();
  return client_->ask(what);
}

void WizardDesk::find_wizard() {
  if (own_ && !own_->serves()) {
    client_.reset();
    own_.reset();
  }
  if (client_ && (own_ || WizardPost::is_held(kWizardDomain))) return;
  client_.reset();
  int domain = kWizardDomain;
  if (!cases_.empty() || !WizardPost::is_held(kWizardDomain)) {
    own_ = std::make_shared<Own>(program_, folder_, cases_);
    domain = own_->domain();
  }
  client_.emplace(WizardClient::Settings{domain, kPatience});
}

}  // namespace tacit
