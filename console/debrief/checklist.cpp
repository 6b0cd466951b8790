#include "console/debrief/checklist.h"

#include <algorithm>

namespace tacit {

std::size_t Checklist::done() const {
  return static_cast<std::size_t>(
      std::count_if(tasks.begin(), tasks.end(), [](const SubTask& task) { return task.done; }));
}

double Checklist::score() const {
  return tasks.empty() ? 1.0 : static_cast<double>(done()) / static_cast<double>(wanted());
}

}  // namespace tacit
