#include "deploy/tacit/cast.h"

#include <array>
#include <charconv>

#include "deploy/tacit/scenario_library.h"
#include "idl/scenario/values.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

std::string hexadecimal(std::uint32_t number) {
  std::array<char, 8> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return {digits.data(), end.ptr};
}

void append(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

Words place(Venue venue) {
  return {"--domain", std::to_string(venue.domain), "--run-nonce", hexadecimal(venue.run_nonce)};
}

Words place_and_scenario(Venue venue, const RunDirectory& directory) {
  Words words = place(venue);
  append(words, {"--scenario", directory.scenario_file().string()});
  return words;
}

fs::path log_of(const RunDirectory& directory, const std::string& name) {
  return directory.path() / "logs" / (name + ".log");
}

Program world(const RunPlan& plan, const RunDirectory& directory, Venue venue) {
  Program program{"the world server", program_folder() / "world_server",
                  place_and_scenario(venue, directory), log_of(directory, "world_server")};
  const RunWish& wish = plan.wish;
  append(program.arguments,
         {"--await-console", "--speed", wish.speed > 0 ? toml_number(wish.speed) : "max"});
  if (wish.patience_ms) {
    append(program.arguments, {"--patience-ms", std::to_string(*wish.patience_ms)});
  }
  if (wish.trajectories) {
    program.arguments.emplace_back("--trajectories");
  }
  return program;
}

/// The run directory is there already, so the console always takes up where somebody left off.
Program console(const RunPlan& plan, const RunDirectory& directory, Venue venue) {
  Program program{"the console", program_folder() / "console", place(venue), {}};
  append(program.arguments,
         {"--resume", "--out", directory.path().string(), "--store", plan.store.string()});
  if (plan.wish.trajectories) {
    program.arguments.emplace_back("--trajectories");
  }
  if (!plan.tape.empty()) {
    append(program.arguments, {"--record", plan.tape.string()});
  }
  if (plan.wish.quiet) {
    program.arguments.emplace_back("--quiet");
  }
  return program;
}

Program agent(const RunPlan& plan, std::int64_t id, const RunDirectory& directory, Venue venue) {
  const std::string number = std::to_string(id);
  const std::string file = "robot_agent-" + number;
  Program program{"robot_agent " + number, program_folder() / "robot_agent",
                  place_and_scenario(venue, directory), log_of(directory, file)};
  const fs::path memory = directory.path() / "logs" / (file + ".memory");
  append(program.arguments, {"--id", number, "--memory", memory.string()});
  if (!plan.policies.empty()) {
    append(program.arguments, {"--inherit", directory.inherited().file_of(id).string()});
  }
  if (const auto folder = learned_folder(plan, directory)) {
    append(program.arguments, {"--learned", folder->file_of(id).string()});
  }
  return program;
}

}  // namespace

Cast cast_for(const RunPlan& plan, const RunDirectory& directory, Venue venue) {
  Cast cast{world(plan, directory, venue), console(plan, directory, venue), {}};
  for (std::int64_t id = 1; id <= plan.setup.world.robots.count; ++id) {
    cast.agents.push_back(agent(plan, id, directory, venue));
  }
  return cast;
}

}  // namespace tacit
