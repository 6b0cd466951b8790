#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "console/record/files.h"
#include "console/record/record_error.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/scenario_library.h"
#include "deploy/tacit/scene_json.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit scene runs/guard-7-20300131T235959Z     the ground of a recorded run, obstacles included
  tacit scene --map office.ovl

Exit codes: 0 done, 2 no run directory or map that makes sense.)";

struct SceneWish {
  std::string run;
  std::string map;
};

Exit tell_scene(const SceneWish& wish) {
  if (wish.run.empty() == wish.map.empty()) {
    throw ConfigError("scene: wanted a run directory or --map FILE.ovl, one of them");
  }
  if (!wish.run.empty()) {
    std::cout << scene_of_run(RunDirectory::open(wish.run)) << std::endl;
    return Exit::Done;
  }
  const std::filesystem::path file = find_shipped(wish.map, "maps", ".ovl");
  try {
    std::cout << scene_of_map(read_whole_file(file), file.stem().string()) << std::endl;
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
  return Exit::Done;
}

}  // namespace

void add_scene(CLI::App& app, Exit& ending) {
  CLI::App* command =
      app.add_subcommand("scene", "What does not move in a run or on a map, as JSON");
  const auto wish = std::make_shared<SceneWish>();
  command->add_option("run", wish->run, "Run directory");
  command->add_option("--map", wish->map, "MissionLab overlay, or the name of one that ships")
      ->type_name("FILE.ovl");
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = tell_scene(*wish); });
}

}  // namespace tacit
