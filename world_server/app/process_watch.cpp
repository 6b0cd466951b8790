#include "world_server/app/process_watch.h"

#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include "idl/bus/host_name.h"

namespace tacit {

ProcessWatch::ProcessWatch(std::size_t slots) : files_(slots, -1), ended_(slots, false) {}

ProcessWatch::~ProcessWatch() {
  for (std::size_t slot = 0; slot < files_.size(); ++slot) forget(slot);
}

void ProcessWatch::watch(std::size_t slot, std::int32_t pid, const std::string& host) {
  forget(slot);
  if (host != host_name()) return;
  files_[slot] = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
  // Any other error (no more files, an old kernel) leaves the process to the bus's own notice.
  ended_[slot] = files_[slot] < 0 && errno == ESRCH;
}

void ProcessWatch::forget(std::size_t slot) {
  if (files_[slot] >= 0) close(files_[slot]);
  files_[slot] = -1;
  ended_[slot] = false;
}

void ProcessWatch::look() {
  std::vector<pollfd> polled;
  polled.reserve(files_.size());
  for (const int file : files_) polled.push_back({file, POLLIN, 0});
  if (poll(polled.data(), polled.size(), 0) <= 0) return;
  for (std::size_t slot = 0; slot < polled.size(); ++slot) {
    if (polled[slot].revents != 0) ended_[slot] = true;
  }
}

}  // namespace tacit
