#pragma once

#include <chrono>

namespace tacit {

/// Signals as something to wait for: SIGINT, SIGTERM and SIGHUP ask for an early end, SIGCHLD says
/// that a child has changed. While one of these lives, none of them acts on its own. One per
/// process, made before any thread.
class Signals {
 public:
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Returns at the first signal, or after `patience`.
  void wait(std::chrono::milliseconds patience);
  /// Whether an early end has been asked for. Sees what `wait` has taken.
  [[nodiscard]] bool end_wanted() const { return end_wanted_; }

  /// Lets the signals act again as they do in a fresh process; for a child before it runs another
  /// program.
  static void restore_in_child();

 private:
  int file_;
  bool end_wanted_ = false;
};

}  // namespace tacit
