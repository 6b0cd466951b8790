#include "deploy/tacit/progress_line.h"

#include <unistd.h>

#include <iostream>

namespace tacit {

ProgressLine::ProgressLine(Style style)
    : silent_(style == Style::Silent), terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const Progress& progress) {
  if (silent_) {
    return;
  }
  if (terminal_) {
    std::cerr << '\r' << progress_text(progress) << "\x1b[K" << std::flush;
  } else {
    std::cerr << progress_text(progress) << std::endl;
  }
  shown_ = true;
  last_ = std::chrono::steady_clock::now();
}

void ProgressLine::finish() {
  if (shown_ && terminal_) {
    std::cerr << std::endl;
  }
}

bool ProgressLine::is_due() const {
  const std::chrono::milliseconds pause(terminal_ ? 250 : 5000);
  return !silent_ && std::chrono::steady_clock::now() - last_ >= pause;
}

}  // namespace tacit
