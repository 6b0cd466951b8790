#pragma once

#include <vector>

#include "idl/types/event.h"

namespace tacit {

/// A short run with some of everything, complete and repeatable.
inline std::vector<Event> a_run() {
  return {{0, EnemyCreated{EnemyId{1}, EnemyKind::Normal, {12.5, 200.0}}},
          {0, EnemyCreated{EnemyId{2}, EnemyKind::Decoy, {0.1, 1.0 / 3.0}}},
          {7, Collision{RobotId{2}, Obstruction::Wall, 4}},
          {90, EnemyIntercepted{EnemyId{1}, EnemyKind::Normal, RobotId{2}, 61.25}},
          {100, Checkpoint{0x123456789abcdef0, 1, 14.5, 0.25}},
          {140, TargetHit{EnemyId{3}, 1.75}},
          {150, RunEnded{0xfeed}}};
}

/// The log's text for these events.
inline std::string lines_of(const std::vector<Event>& events) {
  std::string lines;
  for (const Event& event : events) {
    lines += to_line(event) + '\n';
  }
  return lines;
}

}  // namespace tacit
