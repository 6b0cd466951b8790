#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "console/record/sha256.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/remake.h"
#include "deploy/tacit/say.h"
#include "idl/types/config_error.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Example:
  tacit verify runs/guard-7-20300131T235959Z

Exit codes: 0 the event logs are the same, 2 not a run directory, 5 they differ, or the run is not
one that can be made again.)";

std::string shown(const std::string& line, const char* when_empty) {
  return line.empty() ? when_empty : line;
}

void tell(const Difference& difference) {
  std::cout << "They part at line " << difference.line << ", tick " << difference.tick
            << ":\n  recorded: " << shown(difference.recorded, "(the log ends)")
            << "\n  remade:   " << shown(difference.remade, "(the run is over)") << std::endl;
}

/// Why the run as recorded is not one to compare with; empty when it is.
std::string objection(const RunDirectory& directory) {
  const std::optional<RunOutcome> outcome = directory.outcome();
  if (!outcome) {
    return "The run has no metrics.json: it did not end in good order.";
  }
  if (!outcome->complete) {
    return "The run is incomplete: " + outcome->incomplete_because + '.';
  }
  if (!outcome->repeatable) {
    return "The run is marked as not repeatable: a robot was lost or late, or an operator "
           "acted.";
  }
  if (sha256_of_file(directory.events_file()) != outcome->event_log_sha256) {
    return "events.jsonl does not have the hash that metrics.json names: a file has been changed.";
  }
  return "";
}

Exit verify(const std::string& path) {
  const RunDirectory directory = RunDirectory::open(path);
  const std::string why_not = objection(directory);
  if (!why_not.empty()) {
    std::cout << why_not << std::endl;
  }
  if (directory.facts().version != version()) {
    say("the run was made by version " + directory.facts().version + ", this is " +
        std::string(version()));
  }
  const Remake again = remake(directory);
  if (again.difference) {
    tell(*again.difference);
    return Exit::HashesDiffer;
  }
  std::cout << "The event logs are the same: " << again.ticks << " ticks, SHA-256 " << again.sha256
            << std::endl;
  return why_not.empty() ? Exit::Done : Exit::HashesDiffer;
}

}  // namespace

void add_verify(CLI::App& app, Exit& ending) {
  CLI::App* command =
      app.add_subcommand("verify", "Make a recorded run again and compare the event logs");
  const auto path = std::make_shared<std::string>();
  command->add_option("run", *path, "Run directory")->required();
  command->footer(kExamples);
  command->callback([path, &ending] { ending = verify(*path); });
}

}  // namespace tacit
