#include "console/app/status_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace tacit {
namespace {

constexpr std::chrono::milliseconds kOverwritingPeriod{200};
constexpr std::chrono::seconds kLinesPeriod{5};

std::size_t terminal_width() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

StatusLine::Mode StatusLine::fitting_mode() {
  const char* terminal = std::getenv("TERM");
  const bool capable = terminal != nullptr && std::string_view(terminal) != "dumb";
  return capable && ::isatty(STDERR_FILENO) == 1 ? Mode::Overwriting : Mode::Lines;
}

void StatusLine::show(const std::string& text) {
  if (Clock::now() >= next_) {
    show_now(text);
  }
}

void StatusLine::show_now(const std::string& text) {
  if (mode_ == Mode::Overwriting) {
    // A line as wide as the terminal would wrap.
    std::fprintf(stderr, "\r\033[K%s", text.substr(0, terminal_width() - 1).c_str());
    unfinished_ = true;
    next_ = Clock::now() + kOverwritingPeriod;
  } else if (mode_ == Mode::Lines) {
    std::fprintf(stderr, "%s\n", text.c_str());
    next_ = Clock::now() + kLinesPeriod;
  }
}

void StatusLine::end() {
  if (unfinished_) {
    std::fputc('\n', stderr);
    unfinished_ = false;
  }
}

}  // namespace tacit
