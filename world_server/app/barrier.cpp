#include "world_server/app/barrier.h"

namespace tacit {
namespace {

RobotId id_of(std::size_t index) { return {static_cast<std::uint16_t>(index + 1)}; }

}  // namespace

Barrier::Barrier(std::size_t robots, std::function<void()> on_complete)
    : on_complete_(std::move(on_complete)), slots_(robots, Slot::Unused), commands_(robots) {
  closed_.reserve(robots);
}

void Barrier::open(Tick tick, const std::vector<bool>& awaited) {
  const std::lock_guard lock(mutex_);
  tick_ = tick;
  outstanding_ = 0;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    slots_[i] = awaited[i] ? Slot::Awaited : Slot::Unused;
    outstanding_ += awaited[i] ? 1 : 0;
  }
}

Arrival Barrier::put(const Command& command) {
  const std::size_t index = static_cast<std::size_t>(command.robot.value) - 1;
  if (index >= slots_.size()) return Arrival::Stranger;
  {
    const std::lock_guard lock(mutex_);
    if (command.tick != tick_ || slots_[index] == Slot::Unused) return Arrival::OffTick;
    if (slots_[index] == Slot::Filled) return Arrival::Known;
    slots_[index] = Slot::Filled;
    commands_[index] = command;
    if (--outstanding_ > 0) return Arrival::Awaited;
  }
  on_complete_();
  return Arrival::Awaited;
}

void Barrier::excuse(RobotId robot) {
  const std::lock_guard lock(mutex_);
  Slot& slot = slots_.at(static_cast<std::size_t>(robot.value) - 1);
  if (slot == Slot::Awaited) --outstanding_;
  slot = Slot::Unused;
}

bool Barrier::complete() const {
  const std::lock_guard lock(mutex_);
  return outstanding_ == 0;
}

std::vector<RobotId> Barrier::missing() const {
  const std::lock_guard lock(mutex_);
  std::vector<RobotId> out;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i] == Slot::Awaited) out.push_back(id_of(i));
  }
  return out;
}

std::span<const Command> Barrier::close() {
  const std::lock_guard lock(mutex_);
  closed_.clear();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i] == Slot::Filled) closed_.push_back(commands_[i]);
    slots_[i] = Slot::Unused;
  }
  outstanding_ = 0;
  return closed_;
}

}  // namespace tacit
