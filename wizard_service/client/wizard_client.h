#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>

#include "idl/bus/identity.h"
#include "idl/types/plan_answer.h"
#include "idl/types/plan_request.h"

namespace tacit {

/// No wizard said anything; the text says where and for how long.
class WizardSilent : public std::runtime_error {
 public:
  explicit WizardSilent(const std::string& text) : std::runtime_error(text) {}
};

/// Asks the wizard of a domain on this host. For one thread.
///
/// A request is sent again until it is answered; the wizard does it once however often it comes. A
/// wizard that went down and came back is found again.
class WizardClient {
 public:
  using What = decltype(WizardRequest::what);
  using Reply = std::variant<PlanAnswer, WizardDone, WizardRefusal>;
  using Progress = std::function<void(const WizardProgress&)>;
  using Cancelled = std::function<bool()>;

  struct Settings {
    int domain = kWizardDomain;
    /// Without a sign of life.
    std::chrono::milliseconds patience{30'000};
  };

  /// Throws BusError.
  explicit WizardClient(const Settings& settings);
  ~WizardClient();
  WizardClient(WizardClient&&) noexcept;
  WizardClient& operator=(WizardClient&&) noexcept;

  /// The wizard's last word. `cancelled` is asked a few times a second; when it says so there is a
  /// refusal. Throws WizardSilent, and BusError when the bus cannot be set up anew.
  [[nodiscard]] Reply ask(What what, const Progress& progress = {},
                          const Cancelled& cancelled = {});

  /// What it is called in its requests.
  [[nodiscard]] std::uint64_t id() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
