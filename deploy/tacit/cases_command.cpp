#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <set>

#include "console/record/files.h"
#include "console/record/record_error.h"
#include "deploy/tacit/case_list.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/open_cases.h"
#include "deploy/tacit/say.h"
#include "idl/types/config_error.h"
#include "idl/types/lowered.h"
#include "wizard_service/cases/case_text.h"
#include "wizard_service/cases/cbl.h"
#include "wizard_service/cbr/features.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExamples = R"(Examples:
  tacit cases list --task biohazard --robots 2
  tacit cases show 3
  tacit cases import my_search.cdl library.cbl       all of them or none
  tacit cases export --out cases                     each case a file that import takes
  tacit cases rate 3 bad --because "It missed the last room."
  tacit cases remove 7 8
  tacit cases flaws                                  rows that cannot be used, and why

The cases are those of --cases FILE, else of $XDG_DATA_HOME/tacit/cases.db or
~/.local/share/tacit/cases.db; a new file begins with the cases that ship.

Exit codes: 0 done, 1 the file cannot be read or written, 2 bad input, and flaws that were found.
docs/wizard.md says what a case is.)";

struct CasesWish {
  CaseFileWish base;
  std::string task;
  std::optional<int> robots;
  bool json = false;
  CaseId id = 0;
  std::vector<CaseId> ids;
  std::vector<std::string> files;
  std::string out;
  bool force = false;
  std::string verdict;
  std::string because;
};

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

void tell_of_flaws(cbr::CaseBase& base) {
  const std::size_t count = base.flaws().size();
  if (count > 0) {
    say("left out " + counted(count, "row") + " that cannot be used; see `tacit cases flaws`");
  }
}

Exit list_cases(const CasesWish& wish) {
  std::optional<Task> task;
  if (!wish.task.empty()) task = cbr::task_called(wish.task);
  const auto base = open_cases(wish.base);
  std::vector<cbr::Case> cases = base->listed();
  std::erase_if(cases, [&](const cbr::Case& one) {
    return (task && one.features.task != *task) ||
           (wish.robots && one.features.robots != *wish.robots);
  });
  std::cout << (wish.json ? cases_json(cases) + '\n' : to_text(case_table(cases))) << std::flush;
  tell_of_flaws(*base);
  return Exit::Done;
}

Exit show_case(const CasesWish& wish) {
  const auto base = open_cases(wish.base);
  std::cout << cbr::to_text(base->find(wish.id)) << std::flush;
  return Exit::Done;
}

std::vector<cbr::Case> cases_in(const std::string& file) {
  const std::string ending = lowered(fs::path(file).extension().string());
  if (ending != ".cdl" && ending != ".cbl") {
    throw ConfigError(file + ": wanted a case (.cdl) or a case library (.cbl)");
  }
  try {
    const std::string text = read_whole_file(file);
    if (ending == ".cbl") return cbr::cases_from_cbl(text, file);
    return {cbr::case_from(text, file)};
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
}

/// Of all files. Throws ConfigError that tells what is wrong with each.
std::vector<cbr::Case> cases_in(const std::vector<std::string>& files) {
  std::vector<cbr::Case> cases;
  std::string mistakes;
  for (const std::string& file : files) {
    try {
      std::vector<cbr::Case> more = cases_in(file);
      std::move(more.begin(), more.end(), std::back_inserter(cases));
    } catch (const ConfigError& error) {
      mistakes += (mistakes.empty() ? "" : "\n") + std::string(error.what());
    }
  }
  if (!mistakes.empty()) throw ConfigError(mistakes);
  return cases;
}

Exit import_cases(const CasesWish& wish) {
  const std::vector<cbr::Case> cases = cases_in(wish.files);
  const auto base = open_cases(wish.base);
  const std::vector<cbr::Stored> stored = base->store(cases);
  const auto fresh = static_cast<std::size_t>(std::count_if(
      stored.begin(), stored.end(), [](const cbr::Stored& one) { return one.fresh; }));
  const std::size_t old = stored.size() - fresh;
  std::cout << "Stored " << counted(fresh, "new case") << "; " << old
            << (old == 1 ? " was" : " were") << " there." << std::endl;
  return Exit::Done;
}

/// All that can be used when nobody names any.
std::vector<CaseId> wanted_ids(cbr::CaseBase& base, const std::vector<CaseId>& named) {
  if (!named.empty()) return named;
  std::vector<CaseId> ids;
  for (const cbr::CaseHead& head : base.heads()) ids.push_back(head.id);
  tell_of_flaws(base);
  return ids;
}

struct Draft {
  fs::path file;
  std::string text;
};

void refuse_overwriting(const std::vector<Draft>& drafts) {
  std::string mistakes;
  for (const Draft& draft : drafts) {
    if (!fs::exists(draft.file)) continue;
    mistakes += draft.file.string() + ": is there already\n";
  }
  if (!mistakes.empty()) throw ConfigError(mistakes + "wanted --force, or another --out");
}

Exit export_cases(const CasesWish& wish) {
  const auto base = open_cases(wish.base);
  std::vector<Draft> drafts;
  for (const CaseId id : wanted_ids(*base, wish.ids)) {
    const cbr::Case& one = base->find(id);
    drafts.push_back({fs::path(wish.out) / case_file_name(one), cbr::to_text(one)});
  }
  if (!wish.force) refuse_overwriting(drafts);
  fs::create_directories(wish.out);
  for (const Draft& draft : drafts) write_whole_file(draft.file, draft.text);
  std::cout << "Wrote " << counted(drafts.size(), "case") << " to " << wish.out << std::endl;
  return Exit::Done;
}

double score_of(const std::string& verdict) {
  const std::string word = lowered(verdict);
  if (word == "good") return 1.0;
  if (word == "bad") return 0.0;
  double score = -1.0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, score);
  if (error != std::errc() || stop != end || !(score >= 0.0 && score <= 1.0)) {
    throw ConfigError("found the verdict \"" + verdict +
                      "\", wanted good, bad or a number from 0 to 1");
  }
  return score;
}

Exit rate_case(const CasesWish& wish) {
  const double score = score_of(wish.verdict);
  std::vector<cbr::Failure> failures;
  if (!wish.because.empty()) failures.push_back({cbr::one_line(wish.because), ""});
  if (!failures.empty() && score == 1.0) {
    throw ConfigError("--because: found a failure of what is all good, wanted a lower verdict");
  }
  const auto base = open_cases(wish.base);
  base->record_outcome(wish.id, score, failures);
  std::cout << "Case " << wish.id << ": " << record_line(base->find(wish.id).record) << std::endl;
  return Exit::Done;
}

/// Those whose rows cannot be used as well.
std::set<CaseId> all_ids(cbr::CaseBase& base) {
  std::set<CaseId> ids;
  const cbr::Inventory all = base.inventory();
  for (const cbr::CaseHead& head : all.heads) ids.insert(head.id);
  for (const cbr::Flaw& flaw : all.flaws) ids.insert(flaw.id);
  return ids;
}

Exit remove_cases(const CasesWish& wish) {
  const auto base = open_cases(wish.base);
  const std::set<CaseId> there = all_ids(*base);
  const std::set<CaseId> ids(wish.ids.begin(), wish.ids.end());
  std::string mistakes;
  for (const CaseId id : ids) {
    if (there.contains(id)) continue;
    mistakes += (mistakes.empty() ? "" : "\n") + ("case " + std::to_string(id)) + " is not there";
  }
  if (!mistakes.empty()) throw ConfigError(mistakes + "; nothing was removed");
  for (const CaseId id : ids) base->remove(id);
  std::cout << "Removed " << counted(ids.size(), "case") << "; " << base->size() << " are left."
            << std::endl;
  return Exit::Done;
}

Exit tell_flaws(const CasesWish& wish) {
  const auto base = open_cases(wish.base);
  const std::vector<cbr::Flaw> flaws = base->flaws();
  if (wish.json) {
    std::cout << flaws_json(flaws) << '\n';
  } else {
    for (const cbr::Flaw& flaw : flaws) {
      std::cout << "case " << flaw.id << ": " << flaw.reason << '\n';
    }
    std::cout << base->size() << " cases, " << counted(flaws.size(), "flaw") << '\n';
  }
  std::cout << std::flush;
  return flaws.empty() ? Exit::Done : Exit::BadInput;
}

using Work = Exit (*)(const CasesWish&);
using Wish = std::shared_ptr<CasesWish>;

/// Adds sub-commands to `tacit cases`.
class Adder {
 public:
  Adder(CLI::App& cases, Exit& ending) : cases_(cases), ending_(ending) {}

  CLI::App* operator()(const char* name, const char* doc, Work work) const {
    CLI::App* command = cases_.add_subcommand(name, doc);
    command->add_option("--cases", wish->base.file, "The case base [your own]")->type_name("FILE");
    command
        ->add_option("--seeds", wish->base.seeds,
                     "Folder of cases (.cdl) that a new case base begins with [those that ship]")
        ->type_name("DIR");
    command->callback([own = wish, work, ending = &ending_] { *ending = work(*own); });
    return command;
  }

  Wish wish = std::make_shared<CasesWish>();

 private:
  CLI::App& cases_;
  Exit& ending_;
};

void add_reading(const Adder& add) {
  CasesWish& wish = *add.wish;
  CLI::App* list = add("list", "What cases there are", list_cases);
  list->add_option("--task", wish.task, "Those for it alone: biohazard, eod, waypoints, …")
      ->type_name("KIND");
  list->add_option("--robots", wish.robots, "Those for so many robots alone")
      ->type_name("N")
      ->check(CLI::Range(1, kMostPlannedRobots));
  list->add_flag("--json", wish.json, "As JSON");
  add("show", "Print one as a file, its features at the head", show_case)
      ->add_option("id", wish.id, "Its number in the list")
      ->required();
  add("flaws", "Tell rows that cannot be used, and why", tell_flaws)
      ->add_flag("--json", wish.json, "As JSON");
}

void add_exchange(const Adder& add) {
  CasesWish& wish = *add.wish;
  add("import", "Store cases from files, all or none", import_cases)
      ->add_option("files", wish.files, "Cases (.cdl) and case libraries of MissionLab (.cbl)")
      ->type_name("FILE")
      ->required();
  CLI::App* out = add("export", "Write cases as files that import takes", export_cases);
  out->add_option("ids", wish.ids, "Their numbers in the list [all]")->type_name("ID");
  out->add_option("-o,--out", wish.out, "Folder for them; made when it is not there")
      ->type_name("FOLDER")
      ->required();
  out->add_flag("--force", wish.force, "Replace files that are there");
}

void add_judging(const Adder& add) {
  CasesWish& wish = *add.wish;
  CLI::App* rate =
      add("rate", "Say how a use of it went; it counts like a run's debrief", rate_case);
  rate->add_option("id", wish.id, "Its number in the list")->required();
  rate->add_option("verdict", wish.verdict, "good, bad or a number from 0 to 1")
      ->type_name("VERDICT")
      ->required();
  rate->add_option("--because", wish.because, "What went wrong, in a sentence")->type_name("TEXT");
  add("remove", "Take cases out for good", remove_cases)
      ->add_option("ids", wish.ids, "Their numbers in the list")
      ->type_name("ID")
      ->required();
}

}  // namespace

void add_cases(CLI::App& app, Exit& ending) {
  CLI::App* cases = app.add_subcommand("cases", "List, exchange and judge the wizard's cases");
  cases->require_subcommand(1);
  cases->footer(kExamples);
  const Adder add(*cases, ending);
  add_reading(add);
  add_exchange(add);
  add_judging(add);
}

}  // namespace tacit
