#pragma once

#include <chrono>
#include <cstdint>

#include "console/report/progress_text.h"

namespace tacit {

/// A line on standard error that tells how far a run has come: one that changes in place on a
/// terminal, now and then a new one elsewhere.
class ProgressLine {
 public:
  enum class Style : std::uint8_t { Silent, Live };

  explicit ProgressLine(Style style);

  void show(const Progress& progress);
  /// As `show`, unless the last time was a moment ago; `progress()` is made only when needed.
  template <class Make>
  void show_sometimes(const Make& progress) {
    if (is_due()) {
      show(progress());
    }
  }
  /// Ends the line.
  void finish();

 private:
  [[nodiscard]] bool is_due() const;

  bool silent_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace tacit
