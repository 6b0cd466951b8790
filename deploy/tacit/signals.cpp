#include "deploy/tacit/signals.h"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace tacit {
namespace {

sigset_t watched() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) {
    sigaddset(&set, signal);
  }
  return set;
}

}  // namespace

Signals::Signals() {
  const sigset_t set = watched();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  file_ = signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
  if (file_ < 0) {
    throw std::system_error(errno, std::generic_category(), "signalfd");
  }
}

Signals::~Signals() {
  close(file_);
  restore_in_child();
}

void Signals::restore_in_child() {
  const sigset_t set = watched();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void Signals::wait(std::chrono::milliseconds patience) {
  pollfd waiting{file_, POLLIN, 0};
  poll(&waiting, 1,
       static_cast<int>(std::max<std::chrono::milliseconds::rep>(0, patience.count())));
  signalfd_siginfo info{};
  while (read(file_, &info, sizeof info) == sizeof info) {
    end_wanted_ = end_wanted_ || info.ssi_signo != SIGCHLD;
  }
}

}  // namespace tacit
