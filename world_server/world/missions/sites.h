#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "idl/overlay/plan.h"
#include "idl/types/frames.h"
#include "idl/types/percept.h"

namespace tacit {

/// A room or hallway, numbered from 1 in the map's order; 0 in the open.
struct Spot {
  Site site = Site::Open;
  std::uint32_t number = 0;
  friend bool operator==(const Spot&, const Spot&) = default;
};

/// The rooms and hallways of a map.
class Sites {
 public:
  explicit Sites(const MapPlan& plan);

  /// In which room or else hallway `p` lies, in the first one if in several. The rim belongs to it.
  [[nodiscard]] Spot at(const WorldVec& p) const;
  /// Hallway `number` as it lies round a robot in it; none when its centre line has no length.
  [[nodiscard]] std::optional<SeenHallway> hallway(std::uint32_t number,
                                                   const WorldPose& eye) const;

 private:
  struct Box {
    WorldVec low;
    WorldVec high;
  };
  static Box box_of(const std::vector<MapPoint>& outline);
  static bool holds(const Box& box, const std::vector<MapPoint>& outline, const WorldVec& p);

  std::vector<PlanRoom> rooms_;
  std::vector<MapHallway> halls_;
  std::vector<Box> room_boxes_;  ///< Most places lie far from most rooms.
  std::vector<Box> hall_boxes_;
};

}  // namespace tacit
