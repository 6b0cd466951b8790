#pragma once

#include <string>
#include <string_view>

#include "idl/overlay/overlay.h"
#include "idl/types/plan_request.h"
#include "wizard_service/cbr/case.h"
#include "wizard_service/cbr/changes.h"

namespace tacit::cbr {

/// What a piece of a mission is to be fitted to.
struct Fit {
  int robots = 1;
  Environment environment = Environment::Indoor;
  double max_mps = 0.5;
  double base_mps = 0.15;
  MapPoint begin;    ///< Where it begins, in the map's frame.
  MapPoint outside;  ///< Where the way there came into the building from.
  std::string task;  ///< As it is called in what is told: "Task 2, WaypointsTask,".
};

/// Goals of a case that the wizard finds: the places of `Fit` that are called so.
inline constexpr std::string_view kBeginPlace = "Begin";
inline constexpr std::string_view kOutsidePlace = "Outside";

/// The plan of `from` for so many robots, that place and those speeds. Goals that are called Begin
/// and Outside are those of the task at hand, so that a case that brings something out of a
/// building fits any. Robots too many are left out
/// from the last on; of too few the last one's part is played again. Obstacles are avoided as is
/// usual in that environment, if the case is for the other one. Each change is told.
[[nodiscard]] Plan adapt(const Case& from, const Fit& fit, Changes& changes);

/// The gains of MissionLab for ways indoors and outdoors.
struct AvoidGains {
  double gain = 0.0;
  double sphere_m = 0.0;
  double margin_m = 0.0;
};
[[nodiscard]] AvoidGains usual_gains(Environment environment);

}  // namespace tacit::cbr
