#include "deploy/tacit/make_run.h"

#include <fstream>
#include <iostream>

#include "deploy/tacit/dds_run.h"
#include "deploy/tacit/one_process_run.h"
#include "deploy/tacit/run_debrief.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/summary.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

/// None when the run is no operation, and when what was recorded of it cannot be read.
std::optional<Checklist> checklist_of(const RunDirectory& directory) {
  try {
    return debrief_of(directory);
  } catch (const ConfigError& error) {
    say(error.what());
    return std::nullopt;
  }
}

std::optional<Checklist> tell(const RunPlan& plan, const RunDirectory& directory) {
  const std::optional<RunOutcome> outcome = directory.outcome();
  if (!outcome) {
    say("there is no result; what was recorded lies in " + directory.path().string());
    return std::nullopt;
  }
  const std::optional<Checklist> checklist = checklist_of(directory);
  std::cout << (plan.wish.json ? summary_json(directory, *outcome, checklist)
                               : summary_text(directory, *outcome))
            << std::endl;
  if (checklist && !plan.wish.json && !plan.wish.quiet) {
    std::cout << '\n' << checklist_text(*checklist) << std::endl;
  }
  return checklist;
}

}  // namespace

MadeRun make_run(RunWish wish, Signals& signals) {
  const RunPlan plan = tacit::plan(std::move(wish));
  RunDirectory directory = make_directory(plan);
  const Ending ending = plan.wish.one_process ? run_in_one_process(plan, directory, signals)
                                              : run_over_dds(plan, directory, signals);
  if (!ending.because.empty()) {
    say(ending.because);
  }
  std::optional<Checklist> checklist = tell(plan, directory);
  return {std::move(directory), ending.exit, std::move(checklist)};
}

std::vector<std::string> words_typed() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, '\0');) {
    words.push_back(word);
  }
  return words;
}

}  // namespace tacit
