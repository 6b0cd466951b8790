#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "deploy/tacit/commands.h"
#include "deploy/tacit/scenario_library.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit console                                then open the address it tells
  tacit console --port 9000 --runs /data/runs
  tacit console --address 0.0.0.0              from other machines, with the token it tells

The page shows runs as they go, plans missions with the wizard, starts them and tells how they went.
Foxglove, Lichtblick and PlotJuggler connect to the same port. docs/console.md tells more.

Exit codes: 0 ended, 1 the port could not be had or the machine failed, 2 bad input.)";

struct ConsoleWish {
  std::string port = "8080";
  std::string address = "127.0.0.1";
  std::string token;
  std::string runs = "runs";
  std::string cases;
  std::string pages;
  std::vector<std::string> origins;
};

/// Becomes the console.
Exit serve(const ConsoleWish& wish) {
  std::vector<std::string> words{"console",   "serve",      "--port", wish.port,
                                 "--address", wish.address, "--runs", wish.runs};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--token", wish.token);
  add("--cases", wish.cases);
  add("--pages", wish.pages);
  for (const std::string& origin : wish.origins) add("--origin", origin);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string program = (program_folder() / "console").string();
  execv(program.c_str(), arguments.data());
  throw std::runtime_error(program + ": " + std::strerror(errno));
}

}  // namespace

void add_console(CLI::App& app, Exit& ending) {
  CLI::App* command = app.add_subcommand("console", "Serve the page: watch, plan, run, look back");
  const auto wish = std::make_shared<ConsoleWish>();
  command->add_option("--port", wish->port, "0 for any that is free")
      ->type_name("N")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command
      ->add_option("--address", wish->address,
                   "To listen on; beyond this machine a token is needed, which is told")
      ->capture_default_str();
  command->add_option("--token", wish->token, "Needed by whoever comes")->type_name("WORD");
  command->add_option("--runs", wish->runs, "Folder of run directories")
      ->type_name("DIR")
      ->capture_default_str();
  command
      ->add_option("--origin", wish->origins,
                   "A page of another server that may open sockets, as in https://app.foxglove.dev")
      ->type_name("ORIGIN");
  command->add_option("--cases", wish->cases, "Case base of the wizard [its own]")
      ->type_name("FILE");
  command->add_option("--pages", wish->pages, "Folder of the page [as built]")->type_name("DIR");
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = serve(*wish); });
}

}  // namespace tacit
