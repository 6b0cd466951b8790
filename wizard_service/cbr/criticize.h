#pragma once

#include "wizard_service/cbr/changes.h"
#include "wizard_service/cbr/plan.h"

namespace tacit::cbr {

/// What a plan is looked at for beside itself.
struct Worry {
  double max_mps = 0.5;  ///< The fastest that a robot is to go.
  bool enemy = false;    ///< One is expected.
};

/// Finds what in a plan would fail, and mends what can be mended:
///
/// - a rule that waits for a word that nobody says goes ("unspoken-word");
/// - a state that nothing leads to goes ("unreachable-state");
/// - a state that nothing leads out of, or only what may never happen, is given up after 10 s
/// without
///   progress ("dead-end"); a way along a hallway turns about at its end ("missing-trigger");
/// - a robot in whose part no end can be reached is told of ("no-end");
/// - speeds above the limit, of the request or of the robot's type, are lowered ("too-fast");
/// - a search by one robot where an enemy is expected is told of ("no-cover").
///
/// Each finding says what, why and what was changed.
void criticize(Plan& plan, const Worry& worry, Changes& changes);

}  // namespace tacit::cbr
