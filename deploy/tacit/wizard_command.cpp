#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "deploy/tacit/commands.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/wizard_link.h"
#include "idl/bus/wizard_post.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit wizard                         serves until Ctrl-C
  tacit wizard --cases team.db
  tacit wizard --status                is one serving, and from how many cases?

Exit codes: 0 done, 1 the machine failed, 2 bad input, 4 no wizard serves (--status).
docs/wizard.md tells more.)";

struct ServeWish {
  WizardWish wizard;
  bool status = false;
};

Exit tell_status(const ServeWish& wish) {
  const std::string domain = std::to_string(wish.wizard.domain);
  if (!WizardPost::is_held(wish.wizard.domain)) {
    say("no wizard serves domain " + domain + "; start one with tacit wizard");
    return Exit::TimedOut;
  }
  Signals signals;
  try {
    const WizardClient::Reply reply = WizardLink(wish.wizard, signals).ask(AskForState{});
    if (const auto* done = std::get_if<WizardDone>(&reply)) {
      std::cout << "A wizard serves domain " << domain << ". " << done->text << std::endl;
      return Exit::Done;
    }
    if (const auto* refusal = std::get_if<WizardRefusal>(&reply)) say(refusal->text);
    return Exit::Unforeseen;
  } catch (const WizardSilent& error) {
    say(error.what());
    return Exit::TimedOut;
  }
}

/// Becomes the wizard.
Exit serve(const WizardWish& wish) {
  std::vector<std::string> words{"wizard_service", "--domain", std::to_string(wish.domain)};
  if (!wish.cases.empty()) words.insert(words.end(), {"--cases", wish.cases});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(wizard_program().c_str(), arguments.data());
  throw std::runtime_error(wizard_program().string() + ": " + std::strerror(errno));
}

}  // namespace

void add_wizard(CLI::App& app, Exit& ending) {
  CLI::App* command = app.add_subcommand("wizard", "Serve plans over DDS, from a case base");
  const auto wish = std::make_shared<ServeWish>();
  command->add_option("--domain", wish->wizard.domain, "DDS domain on which to serve")
      ->check(CLI::Range(1, kWizardDomain))
      ->capture_default_str();
  CLI::Option* cases =
      command
          ->add_option("--cases", wish->wizard.cases,
                       "Case base, made when it is not there [~/.local/share/tacit/cases.db]")
          ->type_name("FILE");
  command->add_flag("--status", wish->status, "Only tell whether a wizard serves")->excludes(cases);
  command->footer(kExamples);
  command->callback(
      [wish, &ending] { ending = wish->status ? tell_status(*wish) : serve(wish->wizard); });
}

}  // namespace tacit
