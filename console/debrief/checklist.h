#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tacit {

/// One of the things that a mission comes down to.
struct SubTask {
  std::string name;      ///< What was to be done: "Enter Library".
  bool done = false;     ///< Whether it was.
  std::string evidence;  ///< A sentence that says by which robot and when, or what is missing.
  friend bool operator==(const SubTask&, const SubTask&) = default;
};

/// What was wanted of a team and what it did of that.
struct Checklist {
  std::vector<SubTask> tasks;  ///< Of what is not wanted there is no sub-task.

  [[nodiscard]] std::size_t done() const;
  [[nodiscard]] std::size_t wanted() const { return tasks.size(); }
  /// The share that was done, 0 to 1; 1 when nothing is wanted.
  [[nodiscard]] double score() const;
};

}  // namespace tacit
