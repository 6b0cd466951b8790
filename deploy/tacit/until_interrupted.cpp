#include "deploy/tacit/until_interrupted.h"

#include <atomic>
#include <exception>
#include <thread>

#include "deploy/tacit/signals.h"

namespace tacit {

bool until_interrupted(const std::function<void(const std::stop_token&)>& work) {
  constexpr std::chrono::milliseconds kGlance(20);
  Signals signals;
  std::atomic<bool> over = false;
  std::exception_ptr failure;
  {
    std::jthread thread([&](const std::stop_token& stop) {
      try {
        work(stop);
      } catch (...) {
        failure = std::current_exception();
      }
      over = true;
    });
    while (!over) {
      signals.wait(kGlance);
      if (signals.end_wanted()) {
        thread.request_stop();
      }
    }
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  return signals.end_wanted();
}

}  // namespace tacit
