#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "deploy/tacit/signals.h"
#include "wizard_service/client/wizard_client.h"

namespace tacit {

/// Which wizard a person means.
struct WizardWish {
  int domain = kWizardDomain;
  std::string cases;       ///< File of a case base that is to be used whatever wizard serves.
  double patience_s = 30;  ///< Without a sign of life.
};

/// A wizard to ask: the one that serves the domain, or, when there is none or a case base was
/// named, one that is started for this alone and ends with this.
class WizardLink {
 public:
  /// Throws BusError, and std::system_error when a wizard cannot be started.
  WizardLink(const WizardWish& wish, Signals& signals);
  ~WizardLink();
  WizardLink(const WizardLink&) = delete;
  WizardLink& operator=(const WizardLink&) = delete;

  /// The wizard's last word; progress is said on standard error. Throws ConfigError when the wizard
  /// that was started for this found something wrong, with what it said, std::runtime_error when it
  /// died of something else, and as WizardClient::ask.
  [[nodiscard]] WizardClient::Reply ask(WizardClient::What what);

 private:
  class Own;
  Signals& signals_;
  std::unique_ptr<Own> own_;
  std::unique_ptr<WizardClient> client_;
};

/// Where `wizard_service` lies.
[[nodiscard]] std::filesystem::path wizard_program();

}  // namespace tacit
