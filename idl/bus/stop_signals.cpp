#include "idl/bus/stop_signals.h"

#include <atomic>
#include <csignal>

namespace tacit {
namespace {

std::atomic<Bell*> the_bell{nullptr};
std::atomic<bool> signal_came{false};
static_assert(std::atomic<Bell*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void on_signal(int /*number*/) {
  signal_came = true;
  if (Bell* bell = the_bell.load()) {
    bell->ring();
  }
}

void handle(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  ::sigaction(number, &action, nullptr);
}

}  // namespace

StopSignals::StopSignals(Bell& bell) {
  the_bell = &bell;
  handle(SIGINT, on_signal);
  handle(SIGTERM, on_signal);
}

StopSignals::~StopSignals() {
  handle(SIGINT, SIG_DFL);
  handle(SIGTERM, SIG_DFL);
  the_bell = nullptr;
}

bool StopSignals::came() { return signal_came; }

}  // namespace tacit
