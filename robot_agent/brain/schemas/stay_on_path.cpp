#include "robot_agent/brain/schemas/stay_on_path.h"

#include <algorithm>

namespace tacit {

BodyVec StayOnPath::push(const Surroundings& around) {
  const auto& hallway = around.premises.hallway;
  if (!hallway || hallway->width_m <= 0.0) return {};
  const double distance_m = hallway->offset_m.norm();
  return std::min(1.0, distance_m / hallway->width_m) * unit(hallway->offset_m);
}

}  // namespace tacit
