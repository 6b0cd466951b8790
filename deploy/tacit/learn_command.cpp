#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "console/record/files.h"
#include "console/record/policy_folder.h"
#include "deploy/experiment/chain.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/learn_text.h"
#include "deploy/tacit/run_plan.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/signals.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kExamples = R"(Examples:
  tacit learn forage --robots 6 --episodes 30 --seed 1 --policy policies/team
  tacit learn forage --episodes 10 --set brain.q.alpha=0.5 --json

Runs follow one another with seeds S, S+1, ...; in each, every robot begins with what it has learned
in those before. All take place in this process. Over DDS, use `tacit run --policy DIR` again and
again, with a seed of its own each time.

--policy is written after every finished run, so after Ctrl-C it holds what a whole number of runs
taught: go on with the same command and the next seed.

Exit codes: 0 done, 1 the machine failed, 2 bad input, 130 interrupted.)";

struct LearnWish {
  RunWish run;
  std::int64_t episodes = 30;
  std::int64_t evaluate = 5;
};

/// Runs in a row, told about one by one.
class Lesson {
 public:
  Lesson(const LearnWish& wish, const RunPlan& plan)
      : wish_(wish),
        plan_(plan),
        length_{wish.episodes, std::min(wish.evaluate, wish.episodes)},
        chain_(plan.setup, length_, plan.policies),
        folder_(policy_folder(wish.run)) {
    if (folder_) {
      fs::create_directories(folder_->path());
    }
    if (!wish.run.out.empty()) {
      fs::create_directories(wish.run.out);
    }
  }

  Exit make() {
    while (!chain_.done()) {
      const std::optional<Episode> episode = chain_.next([this] { return end_wanted(); });
      if (!episode) {
        return interrupted();
      }
      keep();
      tell(*episode);
    }
    finish();
    return Exit::Done;
  }

 private:
  /// The one asked for, else one in the folder of results.
  static std::optional<PolicyFolder> policy_folder(const RunWish& wish) {
    if (!wish.policy.empty()) {
      return PolicyFolder(fs::absolute(wish.policy));
    }
    return wish.out.empty() ? std::nullopt
                            : std::optional(PolicyFolder(fs::absolute(wish.out) / "policies"));
  }

  bool end_wanted() {
    signals_.wait(std::chrono::milliseconds(0));
    return signals_.end_wanted();
  }

  void keep() const {
    if (folder_ && !chain_.policies().empty()) {
      std::vector<std::string> texts;
      for (const PolicyText& policy : chain_.policies()) {
        texts.push_back(policy.text);
      }
      folder_->save(texts);
    }
  }

  void tell(const Episode& episode) const {
    if (!wish_.run.quiet) {
      std::cerr << episode_text(episode, length_.episodes, elapsed_s()) << std::endl;
    }
  }

  Exit interrupted() const {
    const auto made = static_cast<std::int64_t>(chain_.episodes().size());
    std::string text = "stopped after " + std::to_string(made) + " of " +
                       std::to_string(length_.episodes) + " runs";
    if (folder_ && !chain_.policies().empty()) {
      text += "; what they taught is in " + folder_->path().string() + ", go on with --seed " +
              std::to_string(plan_.setup.run.seed + made);
    }
    say(text);
    if (made > 0 && !wish_.run.quiet) {
      std::cerr << to_text(learned_table(chain_.episodes(), length_.evaluate)) << std::flush;
    }
    return Exit::Interrupted;
  }

  void finish() const {
    const RunOutcome outcome = chain_.outcome(elapsed_s());
    const Table table = learned_table(chain_.episodes(), length_.evaluate);
    const std::string json = learned_json(plan_.facts, length_, outcome,
                                          folder_ ? folder_->path().string() : std::string());
    if (!wish_.run.out.empty()) {
      write_whole_file(fs::path(wish_.run.out) / "learn.json", json + '\n');
      write_whole_file(fs::path(wish_.run.out) / "episodes.csv",
                       to_csv(episodes_table(chain_.episodes())));
    }
    if (wish_.run.json) {
      std::cout << json << std::endl;
    } else {
      std::cout << to_text(table) << "event logs " << outcome.event_log_sha256 << std::endl;
    }
  }

  [[nodiscard]] double elapsed_s() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }

  const LearnWish& wish_;
  const RunPlan& plan_;
  Clock::time_point begin_ = Clock::now();
  Signals signals_;
  ChainLength length_;
  Chain chain_;
  std::optional<PolicyFolder> folder_;
};

Exit learn(LearnWish wish) {
  wish.run.one_process = true;
  const RunPlan plan = tacit::plan(wish.run);
  return Lesson(wish, plan).make();
}

void add_scenario_options(CLI::App& command, RunWish& wish) {
  command.add_option("scenario", wish.scenario, "Name of a scenario, or a file")
      ->capture_default_str();
  command.add_option("--robots", wish.robots, "Size of the team")->type_name("N");
  command.add_option("--learner", wish.learner, "q, homogeneous or heterogeneous")
      ->type_name("NAME");
  command.add_option("--seed", wish.seed, "Seed of the first run; the next has the next")
      ->type_name("N");
  command
      .add_option("--set", wish.settings, "Any parameter of the scenario; see `tacit scenarios`")
      ->type_name("SECTION.KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_learn_options(CLI::App& command, LearnWish& wish) {
  command.add_option("--episodes", wish.episodes, "Runs in a row")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      .add_option("--evaluate", wish.evaluate,
                  "The result's metrics are means over the last so many runs")
      ->type_name("K")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      .add_option(
          "--policy", wish.run.policy,
          "Folder of policies: the robots begin with what is there and keep there what they "
          "learn [DIR/policies of --out, else none]")
      ->type_name("DIR");
  command.add_option("--out", wish.run.out, "Folder that gets learn.json and episodes.csv")
      ->type_name("DIR");
  command.add_flag("--one-process", wish.run.one_process, "In this process; there is no other way");
  command.add_flag("--json", wish.run.json, "Print one JSON object with the result, nothing else");
  command.add_flag("--quiet", wish.run.quiet, "No progress");
}

}  // namespace

void add_learn(CLI::App& app, Exit& ending) {
  CLI::App* command =
      app.add_subcommand("learn", "Run a scenario again and again, learning from run to run");
  const auto wish = std::make_shared<LearnWish>();
  wish->run.scenario = "forage";
  add_scenario_options(*command, wish->run);
  add_learn_options(*command, *wish);
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = learn(*wish); });
}

}  // namespace tacit
