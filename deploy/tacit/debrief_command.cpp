#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "deploy/tacit/commands.h"
#include "deploy/tacit/run_debrief.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit debrief runs/biohazard-7-20300131T235959Z
  tacit debrief runs/biohazard-7-20300131T235959Z --json

Exit codes: 0 told, whatever was done of it, 2 not the run directory of an operation.
docs/missions.md says what is wanted of a team.)";

struct DebriefWish {
  std::string run;
  bool json = false;
};

Exit debrief(const DebriefWish& wish) {
  const std::optional<Checklist> list = debrief_of(RunDirectory::open(wish.run));
  if (!list) {
    throw ConfigError(wish.run + ": is no operation, wanted the run of a mission (.cdl)");
  }
  std::cout << (wish.json ? checklist_json(*list) : checklist_text(*list)) << std::endl;
  return Exit::Done;
}

}  // namespace

void add_debrief(CLI::App& app, Exit& ending) {
  CLI::App* command =
      app.add_subcommand("debrief", "Tell what a recorded operation got done of its sub-tasks");
  const auto wish = std::make_shared<DebriefWish>();
  command->add_option("run", wish->run, "Run directory")->required();
  command->add_flag("--json", wish->json, "As JSON");
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = debrief(*wish); });
}

}  // namespace tacit
