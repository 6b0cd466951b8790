#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "console/record/files.h"
#include "console/record/record_error.h"
#include "console/record/temporary_folder.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/make_run.h"
#include "deploy/tacit/plan_text.h"
#include "deploy/tacit/plan_wish.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/scenario_library.h"
#include "deploy/tacit/wizard_link.h"
#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/request.h"
#include "wizard_service/client/plan_json.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExamples = R"(Examples:
  tacit plan --map office --task biohazard@30,22 --robots 1
  tacit plan --map office --task waypoint@10,6 --task biohazard@Workshop --robots 2 --enemy --explain
  tacit plan --map office --task biohazard@30,22 --out mine.cdl
  tacit plan --map office --task biohazard@30,22 --robots 2 --enemy --run --extra sentry
  tacit plan --map office --task biohazard@30,22 --naive --run

A task is KIND@X,Y in metres as the map counts, or KIND@NAME of one of its places; KIND is biohazard,
eod, waypoint, hostage or rescue. Behind it, each after a slash, what is wanted of this task alone:
/indoor /outdoor /landmarks /maps /enemy /no-enemy.

A wizard that serves the domain (tacit wizard) is asked; when there is none, one is started for this
call. After --run it is told how the plan went, which moves the ratings of the cases it came from.

Exit codes: 0 done, 1 the machine failed, 2 bad input or no plan, 4 the wizard does not answer; with
--run those of tacit run. docs/wizard.md tells more.)";

struct PlanCommandWish {
  PlanWish plan;
  WizardWish wizard;
  std::size_t choose = 1;
  std::string out;
  bool explain = false;
  bool json = false;
  bool run = false;
  bool no_report = false;
  bool store = false;
  std::string title;
  RunWish flight;  ///< With --run.
};

std::string text_of(const std::string& file) {
  try {
    return read_whole_file(file);
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
}

/// A map that a wizard would refuse is refused here, with the file's name.
MapPlan map_of(const std::string& text, const std::string& name) {
  const OverlayReading reading = read_overlay(text);
  refuse_errors(reading.findings, name);
  return plan_of(reading.map, Doors::Open);
}

/// What the wizard said; a refusal becomes a ConfigError.
template <class Wanted>
Wanted expect(WizardClient::Reply reply) {
  if (const auto* refusal = std::get_if<WizardRefusal>(&reply)) throw ConfigError(refusal->text);
  if (auto* wanted = std::get_if<Wanted>(&reply)) return std::move(*wanted);
  throw std::runtime_error("the wizard answered something else than it was asked");
}

std::string title_of(const PlanRequest& request, const std::string& map) {
  std::string text;
  for (const PlacedTask& task : request.tasks) {
    const std::string word(cbr::word(task.task));
    if (text.find(word) == std::string::npos) text += (text.empty() ? "" : ", ") + word;
  }
  return text + " on " + map;
}

/// One call of the command.
class Session {
 public:
  explicit Session(PlanCommandWish wish)
      : wish_(std::move(wish)),
        map_file_(find_shipped(wish_.plan.map, "maps", ".ovl").string()),
        map_name_(fs::path(map_file_).stem().string()),
        map_(text_of(map_file_)),
        request_(request_of(wish_.plan, map_of(map_, map_file_))),
        wizard_(wish_.wizard, signals_) {}

  Exit run() {
    const PlanAnswer answer = expect<PlanAnswer>(wizard_.ask(AskForPlans{request_, map_}));
    tell(answer);
    if (answer.plans.empty()) return Exit::BadInput;
    if (!needs_choice()) return Exit::Done;
    const OfferedPlan& plan = chosen(answer);
    if (!wish_.out.empty()) {
      write_whole_file(wish_.out, plan.mission);
      say("wrote plan " + std::to_string(wish_.choose) + " to " + wish_.out);
    }
    Exit exit = Exit::Done;
    if (wish_.run) exit = fly(plan);
    if (wish_.store && exit == Exit::Done) store(plan);
    return exit;
  }

 private:
  [[nodiscard]] bool needs_choice() const { return !wish_.out.empty() || wish_.run || wish_.store; }

  void tell(const PlanAnswer& answer) const {
    if (wish_.json) {
      // What a run prints stands alone on standard output.
      if (!wish_.run) std::cout << to_json(answer) << std::endl;
      return;
    }
    std::cout << answer_text(request_, answer, wish_.explain) << std::endl;
    if (!needs_choice()) {
      say("keep one with --choose N --out FILE.cdl, fly it with --run, see why with --explain");
    }
  }

  [[nodiscard]] const OfferedPlan& chosen(const PlanAnswer& answer) const {
    if (wish_.choose > answer.plans.size()) {
      throw ConfigError("--choose: found " + std::to_string(wish_.choose) + ", wanted 1 to " +
                        std::to_string(answer.plans.size()));
    }
    return answer.plans[wish_.choose - 1];
  }

  Exit fly(const OfferedPlan& plan) {
    const TemporaryFolder folder("tacit-plan");
    RunWish flight = wish_.flight;
    flight.scenario = (folder.path() / ("plan-" + map_name_ + ".cdl")).string();
    flight.map = map_file_;
    flight.json = wish_.json;
    flight.command_line = words_typed();
    write_whole_file(flight.scenario, plan.mission);
    if (!wish_.json) std::cout << std::endl;
    const MadeRun made = make_run(std::move(flight), signals_);
    if (made.exit == Exit::Done && made.checklist && !wish_.no_report) {
      report(plan, *made.checklist);
    }
    return made.exit;
  }

  void report(const OfferedPlan& plan, const Checklist& list) {
    if (plan.cases.empty()) return;
    ReportOutcome report;
    for (const UsedCase& used : plan.cases) report.cases.push_back(used.id);
    report.score = list.score();
    for (const SubTask& task : list.tasks) {
      if (!task.done) report.failures.push_back(task.name + ": " + task.evidence);
    }
    report.map = map_name_;
    say("told the wizard: " + expect<WizardDone>(wizard_.ask(report)).text);
  }

  void store(const OfferedPlan& plan) {
    const std::string title = wish_.title.empty() ? title_of(request_, map_name_) : wish_.title;
    say(expect<WizardDone>(
            wizard_.ask(StoreMission{plan.mission, title, cbr::features_for(request_)}))
            .text);
  }

  PlanCommandWish wish_;
  std::string map_file_;
  std::string map_name_;
  std::string map_;
  PlanRequest request_;
  Signals signals_;
  WizardLink wizard_;
};

Exit plan_mission(PlanCommandWish wish) {
  try {
    return Session(std::move(wish)).run();
  } catch (const WizardSilent& error) {
    say(error.what());
    return Exit::TimedOut;
  }
}

void add_request_options(CLI::App& command, PlanWish& wish) {
  command.add_option("--map", wish.map, "MissionLab overlay, or the name of one that ships")
      ->required()
      ->type_name("FILE.ovl");
  command.add_option("--task", wish.tasks, "What is to be done where, in this order; see below")
      ->required()
      ->type_name("KIND@X,Y")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--robots", wish.robots, "Size of the team [as the best cases have it]")
      ->type_name("N");
  command.add_flag("--enemy", wish.enemy, "An enemy is expected");
  command.add_option("--max-velocity", wish.max_velocity_mps, "Limit, 0.1 to 1 m/s")
      ->type_name("MPS")
      ->capture_default_str();
  command
      .add_option("--aggressiveness", wish.aggressiveness,
                  "0.1 to 1: the share of the limit that robots go at")
      ->type_name("A")
      ->capture_default_str();
  command.add_option("--top", wish.top, "Plans wanted, 1 to 20")
      ->type_name("N")
      ->capture_default_str();
  command.add_flag("--naive", wish.naive, "Without the wizard: go to each task and nothing else");
}

void add_answer_options(CLI::App& command, PlanCommandWish& wish) {
  command.add_flag("--explain", wish.explain,
                   "Tell which features matched, and every change with its reason");
  command.add_flag("--json", wish.json, "Print one JSON object: the plans; with --run the result");
  command.add_option("--choose", wish.choose, "The plan to keep, run or store, as numbered")
      ->type_name("N")
      ->check(CLI::Range(1, 20))
      ->capture_default_str();
  command.add_option("-o,--out", wish.out, "File for the chosen plan")->type_name("FILE.cdl");
  command.add_option("--domain", wish.wizard.domain, "DDS domain on which a wizard may serve")
      ->check(CLI::Range(1, kWizardDomain))
      ->capture_default_str();
  command
      .add_option("--cases", wish.wizard.cases,
                  "Case base to plan from [that of the wizard, or your own]")
      ->type_name("FILE");
  command
      .add_option("--patience", wish.wizard.patience_s,
                  "Give up when the wizard says nothing for so long")
      ->type_name("S")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
}

void add_flight_options(CLI::App& command, PlanCommandWish& wish) {
  CLI::Option* run = command.add_flag("--run", wish.run, "Run the chosen plan and debrief it");
  const auto with_run = [&](CLI::Option* option) { option->needs(run); };
  with_run(command
               .add_option("--extra", wish.flight.extra,
                           "A mission for robots that are not of the team, such as a sentry")
               ->type_name("FILE.cdl"));
  with_run(command.add_flag("--one-process", wish.flight.one_process,
                            "Run it in one process, without DDS"));
  with_run(command.add_option("--seed", wish.flight.seed, "Seed of the run")->type_name("N"));
  with_run(command.add_option("--run-out", wish.flight.out, "Run directory")->type_name("DIR"));
  with_run(command.add_option("--run-store", wish.flight.store, "Run store that gets a row")
               ->type_name("FILE"));
  with_run(command
               .add_option("--timeout", wish.flight.timeout_s,
                           "End the run after so much wall time; 0: never")
               ->type_name("S")
               ->check(CLI::Range(0.0, 1e9)));
  with_run(command.add_flag("--quiet", wish.flight.quiet, "No progress of the run"));
  with_run(command.add_flag("--no-report", wish.no_report, "Do not tell the wizard how it went"));
  command.add_flag("--store", wish.store,
                   "Keep the chosen plan as cases; with --run, when the run came to its end");
  command.add_option("--title", wish.title, "A short line for the stored cases")->type_name("TEXT");
}

}  // namespace

void add_plan(CLI::App& app, Exit& ending) {
  CLI::App* command =
      app.add_subcommand("plan", "Have the wizard plan a mission from tasks on a map");
  const auto wish = std::make_shared<PlanCommandWish>();
  add_request_options(*command, wish->plan);
  add_answer_options(*command, *wish);
  add_flight_options(*command, *wish);
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = plan_mission(*wish); });
}

}  // namespace tacit
