#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tacit {

/// A folder of its own, gone with all it holds when this goes.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// What a program left behind.
struct Finished {
  int exit_code = -1;  ///< -1 when a signal ended it, or when it did not end in time.
  std::string out;
  std::string err;
};

/// What the program is held to.
struct Limits {
  std::optional<std::size_t> largest_file;  ///< Bytes; a full disk in the small.
};

/// A program that has been started. Killed when this goes, if it still runs.
class Running {
 public:
  /// `words[0]` is the path of the program.
  explicit Running(const std::vector<std::string>& words, const Limits& limits = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  void send(int signal) const;
  /// What it has written to standard error so far.
  [[nodiscard]] std::string said() const;
  /// What it printed so far.
  [[nodiscard]] std::string printed() const;
  /// Waits for its end, at most so long; kills it then.
  Finished finish(std::chrono::seconds patience = std::chrono::seconds(60));

 private:
  Scratch scratch_;
  pid_t pid_;
  bool reaped_ = false;
};

/// The path of a built program.
[[nodiscard]] std::string program(const std::string& name);

/// `tacit` with these arguments, to its end.
[[nodiscard]] Finished tacit(const std::vector<std::string>& arguments, const Limits& limits = {});
/// The words of that call.
[[nodiscard]] std::vector<std::string> tacit_words(const std::vector<std::string>& arguments);

/// Looks again and again until `truth()` or until the time is out; says which.
bool becomes_true(const std::function<bool()>& truth,
                  std::chrono::seconds patience = std::chrono::seconds(30));

[[nodiscard]] std::string text_of(const std::filesystem::path& file);

}  // namespace tacit
