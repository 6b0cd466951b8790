#pragma once

#include <string>
#include <vector>

namespace tacit {

/// One thing that a run needs of the machine, looked at.
struct Check {
  enum class Verdict { Good, Doubtful, Bad };
  std::string what;
  Verdict verdict = Verdict::Good;
  std::string found;  ///< What is there, and what would be better.
};

/// The programs, shared memory, loopback, domains and processors of this machine.
[[nodiscard]] std::vector<Check> check_machine();

}  // namespace tacit
