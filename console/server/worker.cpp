#include "console/server/worker.h"

#include <utility>

namespace tacit {

Worker::Worker() : thread_([this] { run(); }) {}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    home_ = true;
  }
  come_.notify_one();
  thread_.join();
}

void Worker::put(std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(work));
  }
  come_.notify_one();
}

void Worker::run() {
  for (;;) {
    std::function<void()> work;
    {
      std::unique_lock lock(mutex_);
      come_.wait(lock, [this] { return home_ || !waiting_.empty(); });
      if (home_) return;
      work = std::move(waiting_.front());
      waiting_.pop_front();
    }
    work();
  }
}

}  // namespace tacit
