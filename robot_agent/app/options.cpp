#include "robot_agent/app/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "idl/topics/topics.h"
#include "idl/version/version.h"
#include "robot_agent/app/exit_code.h"

namespace tacit {
namespace {

constexpr const char* kAbout =
    "The mind of one robot: hears its percepts, decides, and sends its commands. It knows of no "
    "other robot's agent.";
constexpr const char* kExitCodes =
    "Exit codes: 0 the run is over, 1 the bus could not be set up, 2 bad input or refused by the "
    "world server, 4 no word of a world server, 130 interrupted.";

std::string check_nonce(const std::string& text) {
  const bool hex = text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
  return hex && !text.empty() && text.size() <= 8 ? "" : "wanted 1 to 8 hexadecimal digits";
}

void add_options(CLI::App& app, Options& options, std::string& nonce) {
  app.add_option("--id", options.id, "The robot, from 1")->required()->check(CLI::Range(1, 65535));
  app.add_option("--scenario", options.scenario, "The scenario, in TOML")->required();
  app.add_option("--domain", options.domain, "DDS domain of the run")
      ->required()
      ->check(CLI::Range(1, 100));
  app.add_option("--run-nonce", nonce, "Tells this run from others, up to 8 hexadecimal digits")
      ->required()
      ->check(check_nonce);
  app.add_option("--memory", options.memory,
                 "File that keeps where the brain stands, taken up at the start if it is there");
  app.add_option("--inherit", options.inherit, "Policy of an earlier run to begin with");
  app.add_option("--learned", options.learned, "File that keeps what is learned for later runs");
  app.add_option("--patience", options.patience_s,
                 "Seconds without a world server after which it gives up")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
}

void add_words(CLI::App& app) {
  app.footer(kExitCodes);
  app.set_version_flag("--version", "robot_agent " + std::string(version()));
  app.add_flag_callback(
      "--interface",
      [] {
        std::cout << interface_text(Party::Agent);
        throw CLI::Success();
      },
      "Show the topics it reads and writes");
}

}  // namespace

std::variant<Options, int> read_options(int argc, char** argv) {
  CLI::App app(kAbout, "robot_agent");
  Options options;
  std::string nonce;
  add_options(app, options, nonce);
  add_words(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? static_cast<int>(ExitCode::Done)
                                : static_cast<int>(ExitCode::BadInput);
  }
  options.run_nonce = static_cast<std::uint32_t>(std::stoul(nonce, nullptr, 16));
  return options;
}

}  // namespace tacit
