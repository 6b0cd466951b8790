#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/process/programs.h"

namespace tacit {

/// A run over DDS that goes on for some seconds, and its processes. It has begun when this stands.
class LiveRun {
 public:
  /// `more` are further arguments of `tacit run`. Throws std::runtime_error when it does not begin.
  explicit LiveRun(const std::vector<std::string>& more = {});
  /// The same with three foragers that never get hold of a mine, so that it goes on until it is
  /// told to end.
  [[nodiscard]] static LiveRun of_foragers(const std::vector<std::string>& more);

  [[nodiscard]] Running& launcher() { return launcher_; }
  [[nodiscard]] pid_t world() const { return of("world_server"); }
  [[nodiscard]] pid_t console() const { return of("console"); }
  [[nodiscard]] pid_t agent(int robot) const;
  /// The processes that the launcher has started and that run now.
  [[nodiscard]] std::vector<pid_t> children() const;

  /// The words with which a process was started.
  [[nodiscard]] static std::vector<std::string> words_of(pid_t pid);
  [[nodiscard]] int domain() const { return domain_; }
  [[nodiscard]] std::uint32_t run_nonce() const { return run_nonce_; }
  [[nodiscard]] std::filesystem::path directory() const { return scratch_ / "run"; }
  [[nodiscard]] std::filesystem::path store() const { return scratch_ / "runs.db"; }
  [[nodiscard]] std::string events() const { return text_of(directory() / "events.jsonl"); }

 private:
  LiveRun(std::vector<std::string> scenario, const std::vector<std::string>& speed,
          const std::vector<std::string>& more);
  [[nodiscard]] pid_t of(const std::string& name) const;
  [[nodiscard]] bool has_begun() const;

  Scratch scratch_;
  Running launcher_;
  int domain_ = 0;
  std::uint32_t run_nonce_ = 0;
};

/// Whether a process with this number is there and no zombie.
[[nodiscard]] bool is_alive(pid_t pid);

/// The SHA-256 that the event log of LiveRun's scenario has when nothing disturbs it.
[[nodiscard]] std::string undisturbed_sha256();

}  // namespace tacit
