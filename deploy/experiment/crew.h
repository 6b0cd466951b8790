#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace tacit {

/// How far a row of jobs has come.
struct CrewProgress {
  std::size_t done = 0;
  std::size_t all = 0;
  double wall_s = 0.0;  ///< Since the first was begun.
};

struct CrewOptions {
  unsigned workers = 1;  ///< Threads; at least one is at work.
  /// Called from worker threads, one at a time, before the first and after every job.
  std::function<void(const CrewProgress&)> progress;
};

/// Does the jobs 0 to `count` - 1 on several threads, each once, begun in this order. A job returns
/// whether it came to its end. None is begun any more once `stop` is asked for or one has thrown.
/// Returns when nobody is at work; throws what the first job that threw did.
void share_out(std::size_t count, const CrewOptions& options, const std::stop_token& stop,
               const std::function<bool(std::size_t)>& job);

/// What comes of each of `count` jobs, in their order; nothing of those that were not done.
/// `make(i)` returns a std::optional.
template <class Make>
[[nodiscard]] auto made_by_crew(std::size_t count, const CrewOptions& options,
                                const std::stop_token& stop, Make make) {
  std::vector<decltype(make(std::size_t{}))> made(count);
  share_out(count, options, stop, [&](std::size_t i) {
    made[i] = make(i);
    return made[i].has_value();
  });
  return made;
}

}  // namespace tacit
