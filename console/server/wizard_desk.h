#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "console/server/job.h"
#include "console/server/worker.h"
#include "wizard_service/client/wizard_client.h"

namespace tacit {

/// Asks the wizard, one request after the other, on a thread of its own: the one that serves, or
/// one that is started at the first request and ends with this.
class WizardDesk {
 public:
  /// Hears the last word, or why there is none.
  using Take = std::function<void(WizardClient::Reply)>;

  /// `program` is the wizard's; `folder` takes what it prints; an empty case file is its usual one.
  WizardDesk(std::filesystem::path program, std::filesystem::path folder, std::string cases);

  /// From any thread.
  void ask(WizardClient::What what, Take take);

 private:
  WizardClient::Reply answer(const WizardClient::What& what);
  void find_wizard();

  class Own;
  std::filesystem::path program_;
  std::filesystem::path folder_;
  std::string cases_;
  std::shared_ptr<Own> own_;
  std::optional<WizardClient> client_;
  Worker worker_;  ///< Goes first.
};

}  // namespace tacit
