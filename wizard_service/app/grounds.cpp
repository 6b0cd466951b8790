#include "wizard_service/app/grounds.h"

#include <algorithm>

#include "idl/overlay/reader.h"

namespace tacit {
namespace {

cbr::Terrain terrain_of(const std::string& map) {
  const OverlayReading reading = read_overlay(map);
  refuse_errors(reading.findings, "map");
  return cbr::Terrain(reading.map);
}

}  // namespace

const cbr::Terrain& Grounds::of(const std::string& map) {
  const auto at = std::find_if(kept_.begin(), kept_.end(),
                               [&](const Ground& ground) { return ground.map == map; });
  if (at != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, at);
  } else {
    kept_.push_front({map, terrain_of(map)});
    if (kept_.size() > kMost) kept_.pop_back();
  }
  return kept_.front().terrain;
}

}  // namespace tacit
