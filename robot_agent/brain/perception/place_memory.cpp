#include "robot_agent/brain/perception/place_memory.h"

namespace tacit {

void PlaceMemory::see(const OdometryPose& odometry, const BodyVec& offset_m) {
  place_m_ = odometry.position_m + from_body<OdometryFrame>(odometry.heading, offset_m);
}

std::optional<BodyVec> PlaceMemory::from(const OdometryPose& odometry) const {
  if (!place_m_) return std::nullopt;
  return to_body(odometry.heading, *place_m_ - odometry.position_m);
}

}  // namespace tacit
