#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wizard_service/cbr/case.h"

namespace tacit::cbr {

/// The sub-missions of a finished mission, each a case under its own features, not yet stored.
///
/// A plan that begins its sub-missions with StartSubMission states is cut there; what moves the
/// team to the place and what joins the pieces is left out, so that the piece fits any place.
/// Robots whose states say the same number, as in "BiohazardTask 2", do that sub-mission together;
/// when some say none, the i-th sub-missions of all robots belong together. Any other plan is one
/// piece. `features` are those of each sub-mission in order; the last one counts for all that
/// follow. The number of robots is that of the piece. Throws ConfigError when there are none.
[[nodiscard]] std::vector<Case> pieces_of(const Plan& plan,
                                          const std::vector<CaseFeatures>& features,
                                          std::string_view title);

/// Equal for plans that differ in names, labels, places in the editor, velocities and what they
/// share alone, and in states that nothing leads to: two cases of one digest and the same features
/// are the same case. The robots' types, their order, states, rules and parameters count. 64
/// hexadecimal digits are not promised; compare, do not parse.
[[nodiscard]] std::string likeness(const Plan& plan);

}  // namespace tacit::cbr
