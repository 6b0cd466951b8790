#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "console/record/files.h"
#include "deploy/experiment/wizard_study.h"
#include "deploy/experiment/wizard_study_tables.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/crew_line.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/scenario_library.h"
#include "deploy/tacit/until_interrupted.h"
#include "idl/types/config_error.h"
#include "idl/version/version.h"
#include "wizard_service/cases/seed.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExamples = R"(Examples:
  tacit experiment wizard                                  200 sites, 1 and 2 robots
  tacit experiment wizard --sites 50 --robots 2 --planners wizard --out runs/wizard2

Every site is an office by chance that is come to from outside. Asked for are its way points and the
entry, then a search for the biohazard; several robots meet a sentry. Each plan is carried out once,
with the site's number as the seed: the wizard's best from the cases that ship, a naive one, and the
mission that an expert wrote for such buildings, which begins in the hallway. Ctrl-C tells what was finished.

--out gets study.csv, failures.csv, flights.csv, report.txt and report.json.

Exit codes: 0 done, 1 the machine failed, 2 bad input, 130 interrupted.)";

struct StudyWish {
  WizardStudy study;
  std::vector<std::string> planners{"wizard", "naive", "expert"};
  std::string seeds;
  std::string out;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  bool quiet = false;
  bool json = false;
};

NamedText shipped(const std::string& mission) {
  const fs::path file = find_shipped(mission, "missions", ".cdl");
  return {read_whole_file(file), file.string()};
}

WizardStudy study_of(const StudyWish& wish) {
  WizardStudy study = wish.study;
  study.planners.clear();
  for (const Planner planner : {Planner::Wizard, Planner::Naive, Planner::Expert}) {
    const bool wanted =
        std::find(wish.planners.begin(), wish.planners.end(), word(planner)) != wish.planners.end();
    if (wanted) study.planners.push_back(planner);
  }
  std::sort(study.robots.begin(), study.robots.end());
  study.robots.erase(std::unique(study.robots.begin(), study.robots.end()), study.robots.end());
  study.expert_alone = shipped("biohazard");
  study.expert_team = shipped("biohazard_pair");
  study.sentry = shipped("sentry");
  return study;
}

cbr::CaseShelf cases_of(const StudyWish& wish) {
  const fs::path folder = wish.seeds.empty() ? cbr::shipped_seeds() : fs::path(wish.seeds);
  std::vector<cbr::Case> cases = cbr::seeds_in(folder);
  if (cases.empty()) {
    throw ConfigError("--seeds: found no case in " + folder.string() +
                      ", wanted a folder of cases (.cdl)");
  }
  return cbr::CaseShelf(std::move(cases));
}

/// What a study came to, with all that makes it again.
struct Report {
  Table results;
  Table failures;
  Table flights;
  std::string facts;  ///< A line for people.
  std::string json;
};

std::size_t wanted(const WizardStudy& study) {
  return study.sites * study.robots.size() * study.planners.size();
}

std::string json_of(const WizardStudy& study, const Report& report, std::size_t flown) {
  using Json = nlohmann::ordered_json;
  const Json all{{"version", version()},
                 {"sites", study.sites},
                 {"first_site", study.first},
                 {"max_velocity_mps", study.max_velocity_mps},
                 {"aggressiveness", study.aggressiveness},
                 {"wanted", wanted(study)},
                 {"flown", flown},
                 {"cut_short", flown < wanted(study)},
                 {"results", Json::parse(to_json(report.results))},
                 {"failures", Json::parse(to_json(report.failures))},
                 {"flights", Json::parse(to_json(report.flights))}};
  return all.dump(2) + '\n';
}

Report report_of(const WizardStudy& study, const std::vector<StudyFlight>& flights) {
  Report report{study_table(flights),
                study_failures(flights),
                study_flights_table(flights, std::string(version())),
                {},
                {}};
  report.facts = "tacit " + std::string(version()) + ", sites " + std::to_string(study.first) +
                 " to " + std::to_string(study.first + study.sites - 1) + ", " +
                 std::to_string(flights.size()) + " of " + std::to_string(wanted(study)) +
                 " flights" + (flights.size() < wanted(study) ? "; cut short\n" : "\n");
  report.json = json_of(study, report, flights.size());
  return report;
}

std::string text_of(const Report& report) {
  const std::string failures = report.failures.rows.empty() ? "" : to_text(report.failures) + '\n';
  return to_text(report.results) + '\n' + failures + report.facts;
}

void keep(const Report& report, const fs::path& out) {
  write_whole_file(out / "study.csv", to_csv(report.results));
  write_whole_file(out / "failures.csv", to_csv(report.failures));
  write_whole_file(out / "flights.csv", to_csv(report.flights));
  write_whole_file(out / "report.txt", text_of(report));
  write_whole_file(out / "report.json", report.json);
}

Exit make_study(const StudyWish& wish) {
  const WizardStudy study = study_of(wish);
  cbr::CaseShelf cases = cases_of(wish);
  if (!wish.out.empty()) fs::create_directories(wish.out);
  CrewLine line("flights", wish.quiet);
  std::vector<StudyFlight> flights;
  (void)until_interrupted([&](const std::stop_token& stop) {
    flights = study_flights(study, cases,
                            {wish.jobs, [&line](const CrewProgress& p) { line.show(p); }}, stop);
  });
  line.finish();
  const Report report = report_of(study, flights);
  if (!wish.out.empty()) {
    keep(report, wish.out);
    say("the results are in " + wish.out);
  }
  std::cout << (wish.json ? report.json : text_of(report)) << std::flush;
  return flights.size() < wanted(study) ? Exit::Interrupted : Exit::Done;
}

void add_study_options(CLI::App& command, StudyWish& wish) {
  command.add_option("--sites", wish.study.sites, "Buildings")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, kMostSites))
      ->capture_default_str();
  command
      .add_option("--first", wish.study.first, "Seed of the first building; the next has the next")
      ->type_name("S")
      ->capture_default_str();
  command.add_option("--robots", wish.study.robots, "Sizes of teams, as in 1,2")
      ->type_name("N,N")
      ->delimiter(',')
      ->check(CLI::Range(1, kMostPlannedRobots))
      ->capture_default_str();
  command.add_option("--planners", wish.planners, "Of wizard, naive and expert")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->check(CLI::IsMember({"wizard", "naive", "expert"}))
      ->capture_default_str();
  command
      .add_option("--max-velocity", wish.study.max_velocity_mps, "Limit asked for, 0.1 to 1 m/s")
      ->type_name("MPS")
      ->check(CLI::Range(0.1, 1.0))
      ->capture_default_str();
  command
      .add_option("--aggressiveness", wish.study.aggressiveness,
                  "0.1 to 1: the share of the limit that robots are to go at")
      ->type_name("A")
      ->check(CLI::Range(0.1, 1.0))
      ->capture_default_str();
  command
      .add_option("--seeds", wish.seeds, "Folder of the wizard's cases (.cdl) [those that ship]")
      ->type_name("DIR");
  command.add_option("--out", wish.out, "Folder of results")->type_name("DIR");
  command.add_option("--jobs", wish.jobs, "Flights at once")
      ->type_name("N")
      ->check(CLI::Range(1U, 1024U))
      ->capture_default_str();
  command.add_flag("--json", wish.json, "Print the report as JSON");
  command.add_flag("--quiet", wish.quiet, "No progress");
}

}  // namespace

void add_wizard_study(CLI::App& experiment, Exit& ending) {
  CLI::App* command = experiment.add_subcommand(
      "wizard", "How much the wizard's plans get done, beside naive ones and an expert's");
  const auto wish = std::make_shared<StudyWish>();
  add_study_options(*command, *wish);
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = make_study(*wish); });
}

}  // namespace tacit
