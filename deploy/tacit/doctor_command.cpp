#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "deploy/tacit/commands.h"
#include "deploy/tacit/health.h"
#include "deploy/tacit/launch_bench.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit doctor            is this machine fit?
  tacit doctor --bench    memory of an agent, and time from launch to first tick, by team size

Exit codes: 0 all is well, or only doubtful, 1 something is missing.)";

const char* word(Check::Verdict verdict) {
  switch (verdict) {
    case Check::Verdict::Good:
      return "good";
    case Check::Verdict::Doubtful:
      return "doubtful";
    case Check::Verdict::Bad:
      return "BAD";
  }
  return "";
}

Exit examine() {
  const std::vector<Check> checks = check_machine();
  for (const Check& check : checks) {
    std::cout << std::left << std::setw(10) << word(check.verdict) << std::setw(24) << check.what
              << check.found << '\n';
  }
  const bool fit = std::none_of(checks.begin(), checks.end(), [](const Check& check) {
    return check.verdict == Check::Verdict::Bad;
  });
  return fit ? Exit::Done : Exit::Unforeseen;
}

}  // namespace

void add_doctor(CLI::App& app, Exit& ending) {
  CLI::App* command = app.add_subcommand("doctor", "See whether this machine can run teams");
  const auto bench = std::make_shared<bool>(false);
  command->add_flag("--bench", *bench, "Measure memory and start of teams of 6, 12, 25 and 50");
  command->footer(kExamples);
  command->callback([bench, &ending] {
    ending = examine();
    if (*bench && ending == Exit::Done) {
      ending = bench_launches();
    }
  });
}

}  // namespace tacit
