#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "console/record/files.h"
#include "console/record/run_store.h"
#include "console/report/progress_text.h"
#include "deploy/experiment/battery.h"
#include "deploy/experiment/runner.h"
#include "deploy/experiment/summary.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/scenario_library.h"
#include "deploy/tacit/signals.h"
#include "idl/scenario/scenario_file.h"
#include "idl/types/config_error.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExamples = R"(Examples:
  tacit experiment guard_figures
  tacit experiment deploy/scenarios/guard_figures.toml --workers 4 --out runs/figures
  tacit experiment guard_figures --report-only
  tacit experiment wizard --sites 200              plans by the wizard, naive and by an expert

Stop it with Ctrl-C whenever you like: started again, it goes on where it was. The folder --out
holds runs.db (every run), report.txt, report.json, a CSV file per table and the figures (SVG).

Exit codes: 0 done, 1 the machine failed, 2 bad input, 130 interrupted.)";

struct ExperimentWish {
  std::string file;
  std::string out;
  unsigned workers = std::max(1U, std::thread::hardware_concurrency());
  bool quiet = false;
  bool json = false;
  bool report_only = false;
};

Battery read_battery(const std::string& name_or_file) {
  const fs::path path = find_scenario(name_or_file);
  ScenarioFile file = ScenarioFile::read(path);
  if (!file.has("experiment")) {
    throw ConfigError(path.string() + ": has no section [experiment], wanted an experiment");
  }
  ExperimentConfig config;
  file.fill(config);
  file.refuse_unknown_sections();
  std::vector<fs::path> scenarios;
  for (const std::string& name : scenario_names(config)) {
    scenarios.push_back(find_scenario(name));
  }
  return {config, scenarios, std::string(version())};
}

/// Shows how far a battery has come.
class BatteryLine {
 public:
  explicit BatteryLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

  void show(const BatteryProgress& progress) {
    const bool due = progress.wall_s - shown_s_ >= (terminal_ ? 0.2 : 10.0);
    if (!quiet_ && (due || progress.done == progress.all)) {
      shown_s_ = progress.wall_s;
      std::fprintf(stderr, terminal_ ? "\r%s\033[K" : "%s\n", text(progress).c_str());
      std::fflush(stderr);
    }
  }
  void finish() const {
    if (!quiet_ && terminal_) {
      std::fputc('\n', stderr);
    }
  }

 private:
  static std::string text(const BatteryProgress& p) {
    const std::size_t made = p.done - p.resumed;
    const double share = p.all > 0 ? static_cast<double>(p.done) / static_cast<double>(p.all) : 1;
    std::string left = "-";
    if (made > 0) {
      left = clock_text(p.wall_s / static_cast<double>(made) * static_cast<double>(p.all - p.done));
    }
    char line[160];
    std::snprintf(line, sizeof line, "%zu of %zu runs (%.0f %%)   %.0f ticks/s   %s left", p.done,
                  p.all, 100.0 * share,
                  p.wall_s > 0 ? static_cast<double>(p.ticks) / p.wall_s : 0.0, left.c_str());
    return line;
  }

  bool quiet_;
  bool terminal_;
  double shown_s_ = -1e9;
};

/// Runs what is missing. True when all is there; false when a person ended it early.
bool complete(const Battery& battery, RunStore& store, const ExperimentWish& wish) {
  Signals signals;
  std::atomic<bool> stop = false;
  std::atomic<bool> over = false;
  bool all_there = false;
  std::exception_ptr failure;
  BatteryLine line(wish.quiet);
  {
    const std::jthread work([&] {
      try {
        all_there =
            run_battery(battery, store,
                        {wish.workers, [&line](const BatteryProgress& p) { line.show(p); }, &stop});
      } catch (...) {
        failure = std::current_exception();
      }
      over = true;
    });
    while (!over) {
      signals.wait(std::chrono::milliseconds(100));
      stop = stop || signals.end_wanted();
    }
  }
  line.finish();
  if (failure) {
    std::rethrow_exception(failure);
  }
  return all_there;
}

void write_report(const Battery& battery, const RunStore& store, const fs::path& out) {
  std::string text;
  nlohmann::json all = nlohmann::json::object();
  for (const ReportTable& each : summarize(battery, store)) {
    text += to_text(each.table) + '\n';
    all[each.name] = nlohmann::json::parse(to_json(each.table));
    write_whole_file(out / (each.name + ".csv"), to_csv(each.table));
  }
  for (const ReportFigure& each : draw(battery, store)) {
    write_whole_file(out / (each.name + ".svg"), each.svg);
  }
  write_whole_file(out / "report.txt", text);
  write_whole_file(out / "report.json", all.dump(2) + '\n');
}

void print_report(const fs::path& out, bool json) {
  std::cout << read_whole_file(out / (json ? "report.json" : "report.txt")) << std::flush;
}

Exit experiment(const ExperimentWish& wish) {
  const Battery battery = read_battery(wish.file);
  const fs::path out =
      wish.out.empty() ? fs::path("runs") / battery.config().name : fs::path(wish.out);
  fs::create_directories(out);
  RunStore store(out / "runs.db");
  const bool all_there = wish.report_only || complete(battery, store, wish);
  if (!all_there) {
    say("stopped; the finished runs are in " + (out / "runs.db").string() +
        ", the same command goes on from there");
    return Exit::Interrupted;
  }
  write_report(battery, store, out);
  print_report(out, wish.json);
  return Exit::Done;
}

}  // namespace

void add_experiment(CLI::App& app, Exit& ending) {
  CLI::App* command =
      app.add_subcommand("experiment", "Run a battery of scenarios and tabulate the results");
  const auto wish = std::make_shared<ExperimentWish>();
  command->add_option("experiment", wish->file, "Name of an experiment, or a file");
  command->add_option("--out", wish->out, "Folder of results [runs/NAME]")->type_name("DIR");
  command->add_option("--workers", wish->workers, "Runs made at once")
      ->type_name("N")
      ->check(CLI::Range(1U, 1024U))
      ->capture_default_str();
  command->add_flag("--report-only", wish->report_only, "Tabulate what is there; run nothing");
  command->add_flag("--json", wish->json, "Print the tables as JSON");
  command->add_flag("--quiet", wish->quiet, "No progress");
  command->footer(kExamples);
  command->require_subcommand(0, 1);
  add_wizard_study(*command, ending);
  command->callback([wish, command, &ending] {
    if (!command->get_subcommands().empty()) {
      return;
    }
    if (wish->file.empty()) {
      throw CLI::RequiredError("experiment");
    }
    ending = experiment(*wish);
  });
}

}  // namespace tacit
