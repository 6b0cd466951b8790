#include "deploy/experiment/crew.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

namespace tacit {
namespace {

using Clock = std::chrono::steady_clock;

class Crew {
 public:
  Crew(std::size_t count, const CrewOptions& options, const std::stop_token& stop,
       const std::function<bool(std::size_t)>& job)
      : options_(options), stop_(stop), job_(job) {
    progress_.all = count;
  }

  void work_it_off() {
    report();
    {
      std::vector<std::jthread> workers;
      const std::size_t useful = std::min<std::size_t>(options_.workers, progress_.all);
      for (std::size_t i = 0; i < std::max<std::size_t>(1, useful); ++i) {
        workers.emplace_back([this] { work(); });
      }
    }
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  void work() {
    while (const std::optional<std::size_t> i = take()) {
      try {
        if (job_(*i)) {
          finish();
        }
      } catch (...) {
        fail();
      }
    }
  }

  std::optional<std::size_t> take() {
    const std::lock_guard lock(mutex_);
    const bool over = next_ == progress_.all || stop_.stop_requested() || failure_;
    return over ? std::nullopt : std::optional(next_++);
  }

  void finish() {
    const std::lock_guard lock(mutex_);
    ++progress_.done;
    report();
  }

  void fail() {
    const std::lock_guard lock(mutex_);
    if (!failure_) {
      failure_ = std::current_exception();
    }
  }

  void report() {
    progress_.wall_s = std::chrono::duration<double>(Clock::now() - start_).count();
    if (options_.progress) {
      options_.progress(progress_);
    }
  }

  const CrewOptions& options_;
  const std::stop_token& stop_;
  const std::function<bool(std::size_t)>& job_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::size_t next_ = 0;
  CrewProgress progress_;
  std::exception_ptr failure_;
};

}  // namespace

void share_out(std::size_t count, const CrewOptions& options, const std::stop_token& stop,
               const std::function<bool(std::size_t)>& job) {
  Crew(count, options, stop, job).work_it_off();
}

}  // namespace tacit
