#include "deploy/tacit/crew_line.h"

#include <unistd.h>

#include <cmath>
#include <iostream>
#include <utility>

#include "console/report/progress_text.h"

namespace tacit {

CrewLine::CrewLine(std::string what, bool quiet)
    : what_(std::move(what)), quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void CrewLine::show(const CrewProgress& progress) {
  const bool due = progress.wall_s - shown_s_ >= (terminal_ ? 0.2 : 5.0);
  if (quiet_ || (!due && progress.done != progress.all)) {
    return;
  }
  shown_s_ = progress.wall_s;
  if (terminal_) {
    std::cerr << '\r' << text(progress) << "\x1b[K" << std::flush;
  } else {
    std::cerr << text(progress) << std::endl;
  }
}

void CrewLine::finish() const {
  if (!quiet_ && terminal_) {
    std::cerr << std::endl;
  }
}

std::string CrewLine::text(const CrewProgress& progress) const {
  const auto done = static_cast<double>(progress.done);
  const auto all = static_cast<double>(progress.all);
  std::string text = std::to_string(progress.done) + " of " + std::to_string(progress.all) + ' ' +
                     what_ + " (" + std::to_string(std::lround(100.0 * done / all)) + " %)";
  if (progress.done > 0) {
    text += "   " + clock_text(progress.wall_s / done * (all - done)) + " left";
  }
  return text;
}

}  // namespace tacit
