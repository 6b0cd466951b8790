#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace tacit {

/// Keeps what a brain has learned on disk, so that it survives the process, however that ends.
class MemoryFile {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds kPeriod{500};

  /// An empty path keeps nothing.
  explicit MemoryFile(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] bool keeps() const { return !path_.empty(); }
  [[nodiscard]] bool due(Time now) const { return keeps() && now >= next_; }
  /// What was saved last; none when there is no file.
  [[nodiscard]] std::optional<std::string> load() const;
  /// Puts `memory` in place of what the file held, in one step. What cannot be written is reported
  /// once on standard error; the run goes on without.
  void save(const std::string& memory, Time now);

 private:
  void complain(const std::string& why);

  std::filesystem::path path_;
  std::string saved_;
  Time next_{};
  bool complained_ = false;
};

}  // namespace tacit
