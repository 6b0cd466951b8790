#pragma once

#include <string>
#include <string_view>

#include "wizard_service/cbr/case.h"

namespace tacit::cbr {

/// A case as a file for people: a mission in CDL behind one comment block that holds what the case
/// is found by and what its use has taught.
///
///     /* Case: Two robots assess a building and cover each other.
///      * Task: BiohazardTask
///      * NumberOfRobots: 2
///      * Uses: 3
///      * Outcomes: 9.500 of 10
///      * Failure: Enter Library: No robot of the team was there. on office
///      */
///
/// Task must be given; features that are not are what is usual for it, the number of robots is the
/// mission's. A failure's map stands behind the last " on "; `-` is none.
///
/// Throws ConfigError with `name` and the line when a key or a value is unknown or given twice, and
/// as `plan_of` does. The case has no id yet; its origin is `name`.
[[nodiscard]] Case case_from(std::string_view text, std::string_view name);

/// Reads back to an equal case but for id and origin. Texts are written in one line and without the
/// end of a comment: control letters become blanks, `*/` becomes `* /`, and an " on " in the name
/// of a map "_on_".
[[nodiscard]] std::string to_text(const Case& one);

/// A text that can stand behind a key: in one line, without the end of a comment, no blanks around
/// it.
[[nodiscard]] std::string one_line(std::string_view text);

}  // namespace tacit::cbr
