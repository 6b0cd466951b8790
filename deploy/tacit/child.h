#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tacit {

/// A program and how it is started.
struct Program {
  std::string name;  ///< For messages: "robot_agent 3".
  std::filesystem::path binary;
  std::vector<std::string> arguments;
  /// Takes what it prints; empty: it goes to this process's standard error.
  std::filesystem::path log;
};

/// How a process ended.
struct Death {
  int exit_code = 0;  ///< 0 when it was a signal.
  int signal = 0;     ///< 0 when it was none.

  [[nodiscard]] bool well() const { return exit_code == 0 && signal == 0; }
  /// "ended with exit code 3", "was killed by signal 9 (Killed)".
  [[nodiscard]] std::string words() const;
};

/// A process that this one has started, in a process group of its own. It gets SIGTERM when this
/// process dies. Killed and reaped, if it still runs, when this object goes.
class Child {
 public:
  /// Throws std::system_error when `program` cannot be started.
  explicit Child(const Program& program);
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;

  [[nodiscard]] pid_t pid() const { return pid_; }
  [[nodiscard]] bool running() const { return pid_ > 0; }
  /// How it ended, told once; absent while it runs and afterwards.
  [[nodiscard]] std::optional<Death> reap();
  /// Sends `signal` to its process group; nothing when it has ended.
  void send(int signal) const;

 private:
  pid_t pid_ = -1;  ///< -1 when it has been reaped.
};

/// The last lines of a program's log, for a message; empty when there are none.
[[nodiscard]] std::string last_lines(const std::filesystem::path& log, std::size_t count = 5);

}  // namespace tacit
