#include "deploy/tacit/run_plan.h"

#include <utility>

#include "console/record/run_store.h"
#include "deploy/lockstep/team.h"
#include "deploy/tacit/operation_wish.h"
#include "deploy/tacit/scenario_library.h"
#include "idl/scenario/values.h"
#include "idl/types/config_error.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

void set_if_given(ScenarioFile& file, std::string_view path, const std::string& value,
                  std::string_view option) {
  if (!value.empty()) {
    file.set(path, value, option);
  }
}

void apply(const RunWish& wish, ScenarioFile& file) {
  for (const std::string& setting : wish.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      throw ConfigError("--set: found \"" + setting + "\", wanted section.key=value");
    }
    file.set(setting.substr(0, equals), setting.substr(equals + 1));
  }
  if (!asks_for_mission(wish)) {
    set_if_given(file, "robots.count", wish.robots, "--robots");
    if (!wish.map.empty()) file.set("area.map", toml_string(wish.map), "--map");
  }
  set_if_given(file, "brain.learner", wish.learner, "--learner");
  set_if_given(file, "enemies.strategy", wish.strategy, "--strategy");
  set_if_given(file, "run.seed", wish.seed, "--seed");
  set_if_given(file, "run.duration_s", wish.duration_s, "--duration");
}

/// "2030-01-31T23:59:59Z" as "20300131T235959Z", fit for a file name.
std::string compact(const std::string& time) {
  std::string text;
  for (const char c : time) {
    text += c == '-' || c == ':' ? "" : std::string(1, c);
  }
  return text;
}

/// A directory below runs/ that is not there yet.
fs::path unused_directory(const RunFacts& facts) {
  const std::string name =
      facts.scenario + '-' + std::to_string(facts.seed) + '-' + compact(facts.started);
  fs::path path = fs::path("runs") / name;
  for (int again = 2; fs::exists(path); ++again) {
    path = fs::path("runs") / (name + '-' + std::to_string(again));
  }
  return path;
}

RunFacts facts_of(const RunWish& wish, const Setup& setup) {
  RunFacts facts;
  facts.version = version();
  facts.scenario = setup.run.name;
  facts.seed = setup.run.seed;
  facts.transport = wish.one_process ? "one-process" : "dds";
  facts.robots = setup.world.robots.count;
  facts.learner = setup.brain.learner;
  facts.strategy = strategy(setup);
  facts.command_line = wish.command_line;
  facts.started = utc_now();
  return facts;
}

/// The one asked for, else runs.db beside the run directory.
fs::path store_of(const RunWish& wish, const fs::path& out) {
  if (wish.store.empty()) {
    // With a slash at its end, whether it had one or not, the directory's name is a parent.
    return (fs::absolute(out) / "").lexically_normal().parent_path().parent_path() / "runs.db";
  }
  const fs::path folder = fs::absolute(wish.store).parent_path();
  if (!fs::is_directory(folder)) {
    throw ConfigError("--store: there is no directory " + folder.string());
  }
  return wish.store;
}

/// Where the run is recorded; empty for nowhere. A file that is there is somebody's.
fs::path tape_of(const RunWish& wish, const fs::path& out) {
  if (!wish.record) return {};
  const fs::path file =
      fs::absolute(wish.record_file.empty() ? out / "run.mcap" : fs::path(wish.record_file));
  if (file.extension() != ".mcap") {
    throw ConfigError("--record: found \"" + wish.record_file +
                      "\", wanted a file that ends in .mcap");
  }
  if (!wish.record_file.empty() && !fs::is_directory(file.parent_path())) {
    throw ConfigError("--record: there is no directory " + file.parent_path().string());
  }
  if (fs::exists(file)) throw ConfigError("--record: " + file.string() + " is there already");
  return file;
}

/// Checked here, so that a policy that does not fit is told before anything is made.
std::vector<PolicyText> policies_for(const RunWish& wish, const Setup& setup) {
  if (wish.policy.empty()) {
    return {};
  }
  std::vector<PolicyText> policies =
      PolicyFolder(fs::absolute(wish.policy)).load(setup.world.robots.count);
  if (!policies.empty()) {
    Team(setup.world, setup.brain, seed(setup)).inherit(policies);
  }
  return policies;
}

std::vector<std::string> texts(const std::vector<PolicyText>& policies) {
  std::vector<std::string> texts;
  for (const PolicyText& policy : policies) {
    texts.push_back(policy.text);
  }
  return texts;
}

ScenarioFile scenario_of(const RunWish& wish) {
  if (!wish.extra.empty() || !wish.starts.empty() || !wish.extra_starts.empty()) {
    throw ConfigError("--extra, --start and --extra-start go with a mission file (.cdl), found " +
                      wish.scenario);
  }
  const fs::path path = find_scenario(wish.scenario);
  ScenarioFile file = ScenarioFile::read(path);
  if (file.has("experiment")) {
    throw ConfigError(path.string() +
                      ": is an experiment, wanted a scenario; see `tacit "
                      "experiment --help`");
  }
  return file;
}

void require_fit_for_a_file_name(const std::string& name) {
  if (name.empty() || name.front() == '.' || name.find('/') != std::string::npos) {
    throw ConfigError("[scenario] name = \"" + name + "\": wanted a name fit for a directory");
  }
}

}  // namespace

Setup resolve(const RunWish& wish) {
  ScenarioFile file = asks_for_mission(wish) ? operation_scenario(wish) : scenario_of(wish);
  apply(wish, file);
  Setup setup = read_setup(file);
  require_fit_for_a_file_name(setup.run.name);
  // Whether the obstacles can be placed shows only when they are.
  const Team trial(setup.world, setup.brain, seed(setup));
  return setup;
}

RunPlan plan(RunWish wish) {
  RunPlan plan;
  plan.setup = resolve(wish);
  plan.scenario_toml = to_toml(describing(plan.setup));
  plan.facts = facts_of(wish, plan.setup);
  plan.out = wish.out.empty() ? unused_directory(plan.facts) : fs::path(wish.out);
  plan.store = store_of(wish, plan.out);
  plan.tape = tape_of(wish, plan.out);
  plan.policies = policies_for(wish, plan.setup);
  plan.wish = std::move(wish);
  return plan;
}

RunDirectory make_directory(const RunPlan& plan) {
  RunDirectory directory = RunDirectory::create(plan.out, plan.facts, plan.scenario_toml);
  fs::create_directories(directory.path() / "logs");
  if (!plan.policies.empty()) {
    directory.inherited().save(texts(plan.policies));
  }
  if (const auto learned = learned_folder(plan, directory)) {
    fs::create_directories(learned->path());
  }
  // What cannot take the run's row in the end is to be told now.
  const RunStore store(plan.store);
  return directory;
}

std::optional<PolicyFolder> learned_folder(const RunPlan& plan, const RunDirectory& directory) {
  if (!plan.wish.policy.empty()) {
    return PolicyFolder(fs::absolute(plan.wish.policy));
  }
  return learns(plan.setup.brain) ? std::optional(directory.learned()) : std::nullopt;
}

}  // namespace tacit
