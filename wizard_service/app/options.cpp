#include "wizard_service/app/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "idl/bus/identity.h"
#include "idl/topics/topics.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

constexpr const char* kAbout =
    "Plans missions from cases: answers over DDS what people ask for with tasks and constraints on "
    "a map.";
constexpr const char* kExitCodes =
    "Ends at SIGINT or SIGTERM. Exit codes: 0 ended, 1 the bus could not be set up or the machine "
    "failed, 2 bad input, a damaged case base among it.";

}  // namespace

std::variant<WizardOptions, int> read_wizard_options(int argc, char** argv) {
  CLI::App app(kAbout, "wizard_service");
  WizardOptions options{kWizardDomain, {}, {}};
  app.add_option("--domain", options.domain, "DDS domain on which it answers")
      ->check(CLI::Range(1, kWizardDomain))
      ->capture_default_str();
  app.add_option("--cases", options.cases,
                 "Case base, made when it is not there [~/.local/share/tacit/cases.db]")
      ->type_name("FILE");
  app.add_option("--seeds", options.seeds,
                 "Folder of the cases that a new case base begins with [those that ship]")
      ->type_name("DIR");
  app.footer(kExitCodes);
  app.set_version_flag("--version", "wizard_service " + std::string(version()));
  app.add_flag_callback(
      "--interface",
      [] {
        std::cout << interface_text(Party::Wizard);
        throw CLI::Success();
      },
      "Show the topics it reads and writes");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return static_cast<int>(app.exit(error) == 0 ? WizardExit::Done : WizardExit::BadInput);
  }
  return options;
}

}  // namespace tacit
