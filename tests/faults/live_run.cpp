#include "tests/faults/live_run.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace tacit {
namespace {

/// Four robots for 300 simulated seconds.
std::vector<std::string> scenario() {
  return {"run", "guard", "--robots", "4", "--seed", "3", "--duration", "300", "--json"};
}

/// Three robots that gather mines until they are told to end: no mine can be picked up.
std::vector<std::string> endless_forage() {
  return {
      "run", "forage", "--robots", "3", "--seed", "3", "--json", "--set", "reach.pick_up_m=0.01"};
}

std::vector<std::string> words(const Scratch& scratch, std::vector<std::string> scenario,
                               const std::vector<std::string>& more) {
  std::vector<std::string> all = tacit_words(scenario);
  for (const std::string& word :
       {std::string("--quiet"), std::string("--out"), (scratch / "run").string(),
        std::string("--patience-ms"), std::string("0")}) {
    all.push_back(word);
  }
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<std::string> joined(std::vector<std::string> words,
                                const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string word_after(const std::vector<std::string>& words, const std::string& option) {
  const auto at = std::find(words.begin(), words.end(), option);
  return at == words.end() || at + 1 == words.end() ? "" : *(at + 1);
}

}  // namespace

LiveRun::LiveRun(const std::vector<std::string>& more)
    : LiveRun(scenario(), {"--speed", "100"}, more) {}

LiveRun LiveRun::of_foragers(const std::vector<std::string>& more) {
  return LiveRun(endless_forage(), {"--speed", "1000"}, more);
}

LiveRun::LiveRun(std::vector<std::string> scenario, const std::vector<std::string>& speed,
                 const std::vector<std::string>& more)
    : launcher_(words(scratch_, joined(std::move(scenario), speed), more)) {
  if (!becomes_true([this] { return has_begun(); }, std::chrono::seconds(60))) {
    throw std::runtime_error("the run does not begin: " + launcher_.finish().err);
  }
  const std::vector<std::string> words = words_of(world());
  domain_ = std::stoi(word_after(words, "--domain"));
  run_nonce_ =
      static_cast<std::uint32_t>(std::stoul(word_after(words, "--run-nonce"), nullptr, 16));
}

bool LiveRun::has_begun() const { return events().find('\n') != std::string::npos; }

std::vector<pid_t> LiveRun::children() const {
  const std::string pid = std::to_string(launcher_.pid());
  std::istringstream list(text_of("/proc/" + pid + "/task/" + pid + "/children"));
  std::vector<pid_t> pids;
  for (pid_t child = 0; list >> child;) {
    pids.push_back(child);
  }
  return pids;
}

std::vector<std::string> LiveRun::words_of(pid_t pid) {
  std::istringstream line(text_of("/proc/" + std::to_string(pid) + "/cmdline"));
  std::vector<std::string> words;
  for (std::string word; std::getline(line, word, '\0');) {
    words.push_back(word);
  }
  return words;
}

pid_t LiveRun::of(const std::string& name) const {
  for (const pid_t child : children()) {
    const std::vector<std::string> words = words_of(child);
    if (!words.empty() && words.front() == program(name)) {
      return child;
    }
  }
  throw std::runtime_error("there is no process of " + name);
}

pid_t LiveRun::agent(int robot) const {
  for (const pid_t child : children()) {
    if (word_after(words_of(child), "--id") == std::to_string(robot)) {
      return child;
    }
  }
  throw std::runtime_error("there is no agent of robot " + std::to_string(robot));
}

bool is_alive(pid_t pid) {
  const std::string status = text_of("/proc/" + std::to_string(pid) + "/stat");
  const std::size_t name_end = status.rfind(')');
  return name_end != std::string::npos && status[name_end + 2] != 'Z';
}

std::string undisturbed_sha256() {
  static const std::string kSha256 = [] {
    const Scratch scratch;
    std::vector<std::string> words = scenario();
    for (const char* word : {"--one-process", "--quiet", "--out"}) {
      words.emplace_back(word);
    }
    words.push_back(scratch / "run");
    return nlohmann::json::parse(tacit(words).out)["event_log_sha256"].get<std::string>();
  }();
  return kSha256;
}

}  // namespace tacit
