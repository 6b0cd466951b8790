#pragma once

#include <cstdint>

#include "deploy/lockstep/setup.h"

namespace tacit {

/// A forage scenario whose map is drawn by chance: number, layout and proximity of the mines, the
/// base's place, and how much of the area obstacles cover (what the paper's seven environments
/// vary). A seed from 1 on always draws the same map; hazards and hunters follow the run's seed.
[[nodiscard]] Setup drawn_environment(std::int64_t seed);

}  // namespace tacit
