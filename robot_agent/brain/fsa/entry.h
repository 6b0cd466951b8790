#pragma once

#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

/// When and where a state was entered.
struct Entry {
  Tick tick = 0;
  OdometryPose pose;
};

}  // namespace tacit
