#pragma once

#include <chrono>
#include <string>

namespace tacit {

/// Progress on standard error: on a terminal one line that is written over, else, or on a terminal
/// that cannot do that (TERM=dumb), a line every few seconds. Plain text, without colours.
class StatusLine {
 public:
  enum class Mode { Silent, Overwriting, Lines };
  [[nodiscard]] static Mode fitting_mode();

  explicit StatusLine(Mode mode) : mode_(mode) {}
  ~StatusLine() { end(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Shows `text` if it is time again.
  void show(const std::string& text);
  /// Shows `text` in any case.
  void show_now(const std::string& text);
  /// Leaves the last text standing, so that what follows starts on a line of its own.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  Mode mode_;
  Clock::time_point next_{};
  bool unfinished_ = false;
};

}  // namespace tacit
