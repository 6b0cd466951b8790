#include "world_server/app/attendance.h"

#include <algorithm>

namespace tacit {
namespace {

RobotId id_of(std::size_t index) { return {static_cast<std::uint16_t>(index + 1)}; }

}  // namespace

Attendance::Attendance(const Admission& admission, AgentPort& port)
    : port_(port),
      roster_(admission),
      watch_(admission.robots),
      present_(admission.robots, false) {}

std::vector<Happening> Attendance::hear(const Hello& hello) {
  std::vector<Happening> changes = look();
  const Order order = roster_.admit(hello);
  if (order.kind == OrderKind::Welcome) {
    watch_.watch(static_cast<std::size_t>(hello.robot.value) - 1, hello.pid, hello.host);
  }
  port_.send(order);
  return changes;
}

std::vector<Happening> Attendance::look() {
  std::vector<Happening> changes;
  watch_.look();
  for (std::size_t i = 0; i < present_.size(); ++i) {
    if (!roster_.agent_of(id_of(i))) continue;
    if (has_gone(i)) {
      if (present_[i]) changes.emplace_back(RobotLost{id_of(i)});
      dismiss(i);
    } else if (!present_[i] && port_.connected(id_of(i))) {
      present_[i] = true;
      changes.emplace_back(RobotBack{id_of(i)});
    }
  }
  return changes;
}

std::size_t Attendance::count() const {
  return static_cast<std::size_t>(std::count(present_.begin(), present_.end(), true));
}

std::string Attendance::absent() const {
  std::string text;
  for (std::size_t i = 0; i < present_.size(); ++i) {
    if (!present_[i]) text += (text.empty() ? "" : ", ") + std::to_string(i + 1);
  }
  return text;
}

bool Attendance::has_gone(std::size_t index) const {
  return watch_.ended(index) || (present_[index] && !port_.connected(id_of(index)));
}

void Attendance::dismiss(std::size_t index) {
  roster_.dismiss(id_of(index));
  watch_.forget(index);
  port_.forget(id_of(index));
  present_[index] = false;
}

}  // namespace tacit
