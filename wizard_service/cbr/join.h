#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wizard_service/cbr/changes.h"
#include "wizard_service/cbr/plan.h"
#include "wizard_service/cbr/sites.h"

namespace tacit::cbr {

/// A sub-mission that fits its place and its robots.
struct Piece {
  std::string label;   ///< Of its first state: "BiohazardTask 2".
  std::string number;  ///< Of the task, as a person counts: "2".
  Plan plan;
  Site site;
};

/// The pieces of a squad, each as many robots as the first, one after another.
///
/// Before each stands its joint: states called "Way to N" along the way, then a StartSubMission.
/// Where a piece ends for a robot, that robot goes on to the next joint. A robot whose part in a
/// piece has no end of its own, such as one that covers another, is told by a word when another one
/// ends the piece for all. Where the robots of a piece warn each other of enemies they do so on the
/// way to it, and on the way to the pieces before it, too. `alone` says that nobody else takes part
/// in the mission: then the last piece may end the mission for all; otherwise it ends by a word as
/// well.
[[nodiscard]] Plan join(std::vector<Piece> pieces, const Terrain& terrain, bool alone,
                        Changes& changes);

/// What the labels of states on the way to a sub-mission begin with.
inline constexpr std::string_view kWayLabel = "Way to ";

/// "Task 2 is over.": the word by which robots leave a piece.
[[nodiscard]] std::string release_word(std::string_view number);
[[nodiscard]] bool is_release_word(std::string_view word);

/// Puts `more` robots and what they refer to beside those of `plan`, under names of their own.
void add_robots(Plan& plan, Plan more);

}  // namespace tacit::cbr
