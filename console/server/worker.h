#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace tacit {

/// A thread that does one piece of work after the other.
class Worker {
 public:
  Worker();
  /// Leaves what waits undone, and waits for what is under way.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// From any thread. The work throws nothing.
  void put(std::function<void()> work);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable come_;
  std::deque<std::function<void()>> waiting_;
  bool home_ = false;
  std::thread thread_;
};

}  // namespace tacit
