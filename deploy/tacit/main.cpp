#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <iostream>

#include "console/record/record_error.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/say.h"
#include "idl/types/config_error.h"
#include "idl/types/nearest_word.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

constexpr const char* kAbout =
    "Robot teams that learn to work together without talking.\n"
    "Start with: tacit run guard --robots 6 --learner lm --strategy 1 --seed 7";

/// Throws ConfigError when `word` stands where a command should and is none.
void refuse_unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  const bool known = std::find(names.begin(), names.end(), word) != names.end();
  if (!word.empty() && word.front() != '-' && !known) {
    throw ConfigError("there is no command \"" + word + '"' + did_you_mean(word, names) +
                      " See tacit --help");
  }
}

Exit command_line(int argc, char** argv) {
  CLI::App app(kAbout, "tacit");
  Exit ending = Exit::Done;
  app.set_version_flag("--version", "tacit " + std::string(version()));
  app.require_subcommand(1);
  add_run(app, ending);
  add_learn(app, ending);
  add_experiment(app, ending);
  add_console(app, ending);
  add_plan(app, ending);
  add_wizard(app, ending);
  add_scenarios(app, ending);
  add_preview(app, ending);
  add_scene(app, ending);
  add_watch(app, ending);
  add_operate(app, ending);
  add_replay(app, ending);
  add_verify(app, ending);
  add_debrief(app, ending);
  add_policy(app, ending);
  add_mission(app, ending);
  add_map(app, ending);
  add_cases(app, ending);
  add_doctor(app, ending);
  refuse_unknown_command(app, argc > 1 ? argv[1] : "");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? Exit::Done : Exit::BadInput;
  }
  return ending;
}

}  // namespace
}  // namespace tacit

int main(int argc, char** argv) {
  // A file that may not grow further is an error to be told, not a reason to die.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  tacit::Exit ending = tacit::Exit::Unforeseen;
  try {
    ending = tacit::command_line(argc, argv);
  } catch (const tacit::ConfigError& error) {
    tacit::say(error.what());
    ending = tacit::Exit::BadInput;
  } catch (const std::exception& error) {
    tacit::say(error.what());
  }
  return static_cast<int>(ending);
}
