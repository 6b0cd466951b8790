#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

#include "idl/types/command.h"

namespace tacit {

/// What a command turned out to be.
enum class Arrival {
  Awaited,   ///< The one that was waited for.
  Known,     ///< Its robot has answered this tick already.
  OffTick,   ///< It answers another tick, or nobody waits for its robot.
  Stranger,  ///< Its robot is not in the scenario.
};

/// Gathers one command from each awaited robot for one tick. Commands may come from any thread;
/// the rest is for one thread.
class Barrier {
 public:
  /// Calls `on_complete` when the last awaited command has come, in the thread that brought it;
  /// not when the last one awaited is excused.
  /// `robots` are numbered from 1.
  Barrier(std::size_t robots, std::function<void()> on_complete);

  /// Waits from now on for commands of `tick` by robot i+1 where `awaited[i]`.
  void open(Tick tick, const std::vector<bool>& awaited);
  Arrival put(const Command& command);
  /// Waits for this robot no longer; a command of this tick that it gave counts no more.
  void excuse(RobotId robot);

  [[nodiscard]] bool complete() const;
  [[nodiscard]] std::vector<RobotId> missing() const;
  /// The commands that came, in order of id; later ones of this tick come too late. Valid until the
  /// next `open`.
  [[nodiscard]] std::span<const Command> close();

 private:
  enum class Slot : std::uint8_t { Unused, Awaited, Filled };

  std::function<void()> on_complete_;
  mutable std::mutex mutex_;
  Tick tick_ = 0;
  std::size_t outstanding_ = 0;
  std::vector<Slot> slots_;
  std::vector<Command> commands_;
  std::vector<Command> closed_;
};

}  // namespace tacit
