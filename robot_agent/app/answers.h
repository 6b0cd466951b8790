#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "idl/types/command.h"
#include "idl/types/percept.h"

namespace tacit {

/// One command for each tick, however often and in whatever order its percept comes.
class Answers {
 public:
  using Decide = std::function<Command(const Percept&)>;

  explicit Answers(Decide decide) : decide_(std::move(decide)) {}

  /// Decides on a percept of a new tick and repeats the command for one of the last tick. None for
  /// an older one, which nobody waits for any more. Valid until the next call.
  [[nodiscard]] const Command* to(const Percept& percept);

  [[nodiscard]] std::uint64_t decisions() const { return decisions_; }
  [[nodiscard]] std::uint64_t duplicates() const { return duplicates_; }

 private:
  Decide decide_;
  std::optional<Command> last_;
  std::uint64_t decisions_ = 0;
  std::uint64_t duplicates_ = 0;
};

}  // namespace tacit
