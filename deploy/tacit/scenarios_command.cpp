#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <memory>

#include "deploy/experiment/experiment_config.h"
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
  tacit scenarios guard               the scenario as a file, every parameter written out)";

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

/// The defaults when no scenario is named.
Setup setup_of(const std::string& name) {
  if (name.empty()) {
    return {};
  }
  ScenarioFile file = ScenarioFile::read(find_scenario(name));
  return read_setup(file);
}

void show(const std::string& name, bool explained) {
  Setup setup = setup_of(name);
  std::cout << (explained ? explain(describing(setup)) : to_toml(describing(setup)));
}

}  // namespace

void add_scenarios(CLI::App& app, Exit& ending) {
  CLI::App* command = app.add_subcommand("scenarios", "List scenarios, explain their parameters");
  const auto name = std::make_shared<std::string>();
  const auto explained = std::make_shared<bool>(false);
  command->add_option("scenario", *name, "Name of a scenario, or a file");
  command->add_flag("--explain", *explained, "Every parameter with unit, range, meaning, source");
  command->footer(kExamples);
  command->callback([name, explained, &ending] {
    if (name->empty() && !*explained) {
      list();
    } else {
      show(*name, *explained);
    }
    ending = Exit::Done;
  });
}

}  // namespace tacit
