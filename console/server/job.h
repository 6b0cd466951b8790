#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tacit {

/// A program that was started, in a process group of its own, with what it prints in files.
class Job {
 public:
  enum class Life { EndsWithUs, LivesOn };

  /// `words[0]` is the program's path. `folder` takes what it prints and is made. Throws
  /// std::runtime_error when it cannot be started.
  Job(const std::vector<std::string>& words, const std::filesystem::path& folder, Life life);
  /// Kills it if it is to end with us, and removes the folder.
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  [[nodiscard]] bool running();
  /// Waits at most so long for its end; says whether it came.
  bool wait(std::chrono::milliseconds patience);
  /// Asks it to end early.
  void interrupt();
  /// 128 and the signal when one ended it; none while it runs.
  [[nodiscard]] std::optional<int> exit_code();
  [[nodiscard]] std::string out() const;
  [[nodiscard]] std::string err() const;
  /// The last line of what it told people, without the name in front.
  [[nodiscard]] std::string complaint() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
