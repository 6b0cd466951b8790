#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <memory>

#include "deploy/experiment/experiment_config.h"
#include "deploy/lockstep/environment.h"
#include "deploy/lockstep/setup.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/scenario_library.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit scenarios                     what there is
  tacit scenarios --explain           every parameter: default, unit, range, meaning, source
  tacit scenarios --explain guard     the same with the scenario's own values
  tacit scenarios guard               the scenario as a file, every parameter written out
  tacit scenarios --draw 42           a forage environment drawn by chance, as a file)";

struct ScenariosWish {
  std::string name;
  bool explained = false;
  std::int64_t draw = 0;  ///< Seed of an environment; 0 for none.
};

/// One line about a file of the library; a broken file says why.
std::string description(const LibraryEntry& entry) {
  try {
    ScenarioFile file = ScenarioFile::read(entry.file);
    if (file.has("experiment")) {
      ExperimentConfig experiment;
      file.fill(experiment);
      return "experiment: " + experiment.description;
    }
    RunConfig run;
    file.fill(run);
    return run.description;
  } catch (const ConfigError& error) {
    return std::string("broken: ") + error.what();
  }
}

void list() {
  const std::vector<LibraryEntry> entries = scenario_library();
  std::size_t widest = 0;
  for (const LibraryEntry& entry : entries) {
    widest = std::max(widest, entry.name.size());
  }
  for (const LibraryEntry& entry : entries) {
    std::cout << std::left << std::setw(static_cast<int>(widest + 2)) << entry.name
              << description(entry) << '\n';
  }
}

void print(Setup setup, bool explained) {
  std::cout << (explained ? explain(describing(setup)) : to_toml(describing(setup)));
}

/// The defaults of every mission.
void explain_all() {
  for (const std::string_view mission : kMissionNames) {
    Setup setup;
    setup.run.mission = mission;
    std::cout << "==== mission " << mission << " ====\n\n";
    print(setup, true);
    std::cout << '\n';
  }
}

void show(const ScenariosWish& wish) {
  if (wish.draw > 0) {
    print(drawn_environment(wish.draw), wish.explained);
  } else if (!wish.name.empty()) {
    ScenarioFile file = ScenarioFile::read(find_scenario(wish.name));
    print(read_setup(file), wish.explained);
  } else if (wish.explained) {
    explain_all();
  } else {
    list();
  }
}

}  // namespace

void add_scenarios(CLI::App& app, Exit& ending) {
  CLI::App* command = app.add_subcommand("scenarios", "List scenarios, explain their parameters");
  const auto wish = std::make_shared<ScenariosWish>();
  command->add_option("scenario", wish->name, "Name of a scenario, or a file");
  command->add_flag("--explain", wish->explained,
                    "Every parameter with unit, range, meaning, source");
  command->add_option("--draw", wish->draw, "A forage environment drawn from this seed")
      ->type_name("SEED")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{9'000'000'000'000'000}))
      ->excludes(command->get_option("scenario"));
  command->footer(kExamples);
  command->callback([wish, &ending] {
    show(*wish);
    ending = Exit::Done;
  });
}

}  // namespace tacit
