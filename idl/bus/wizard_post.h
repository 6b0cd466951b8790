#pragma once

#include <filesystem>

#include "idl/bus/lock_file.h"

namespace tacit {

/// Held by the wizard of a domain while it serves, so that there is one on a host and a client can
/// tell at once whether there is any. The kernel lets go of it however the wizard ends.
class WizardPost {
 public:
  /// Throws BusError when another wizard holds it or `folder` cannot be used.
  explicit WizardPost(int domain, const std::filesystem::path& folder = lease_folder());
  ~WizardPost();
  WizardPost(const WizardPost&) = delete;
  WizardPost& operator=(const WizardPost&) = delete;

  /// Whether a wizard of this user serves `domain`.
  [[nodiscard]] static bool is_held(int domain,
                                    const std::filesystem::path& folder = lease_folder());

 private:
  int file_;
};

}  // namespace tacit
