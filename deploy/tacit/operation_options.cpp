#include "deploy/tacit/operation_options.h"

namespace tacit {
namespace {

void add_list(CLI::App& command, const std::string& name, std::vector<std::string>& values,
              const std::pair<const char*, const char*>& type_and_doc) {
  command.add_option(name, values, type_and_doc.second)
      ->type_name(type_and_doc.first)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

void add_operation_options(CLI::App& command, RunWish& wish) {
  command
      .add_option("--map", wish.map,
                  "MissionLab overlay from which area, walls, obstacles and start place come")
      ->type_name("FILE.ovl");
  command
      .add_option(
          "--extra", wish.extra,
          "With a mission: another one, for robots that are not of the team, such as a sentry")
      ->type_name("FILE.cdl");
  command.add_option("--extra-colour", wish.extra_colour, "How those are painted; red is an enemy")
      ->check(CLI::IsMember({"red", "blue"}))
      ->capture_default_str();
  constexpr const char* kPlace = "X,Y[,DEG]";
  add_list(
      command, "--start", wish.starts,
      {kPlace, "With a mission: where the team's robots start and face; the first, the second, …"});
  add_list(command, "--extra-start", wish.extra_starts, {kPlace, "The same for the extra robots"});
  add_list(command, "--set", wish.settings,
           {"SECTION.KEY=VALUE", "Any parameter of the scenario; see `tacit scenarios`"});
}

}  // namespace tacit
