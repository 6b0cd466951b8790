#pragma once

#include <string>
#include <variant>

namespace tacit {

/// How the wizard's service is to run.
struct WizardOptions {
  int domain = 0;
  std::string cases;  ///< File; empty: the person's own.
  std::string seeds;  ///< Folder of cases for a new case base; empty: those that ship.
};

/// Exit codes of the program.
enum class WizardExit : int { Done = 0, Failed = 1, BadInput = 2 };

/// The options, or the code to exit with after what was to be said has been.
[[nodiscard]] std::variant<WizardOptions, int> read_wizard_options(int argc, char** argv);

}  // namespace tacit
