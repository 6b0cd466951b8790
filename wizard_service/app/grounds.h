#pragma once

#include <cstddef>
#include <list>
#include <string>

#include "wizard_service/cbr/terrain.h"

namespace tacit {

/// Maps that were planned on lately; to make one anew takes longer than to plan.
class Grounds {
 public:
  static constexpr std::size_t kMost = 8;

  /// What the text of an overlay says. Throws ConfigError with line and column of each mistake.
  /// Valid until kMost other maps were asked for.
  [[nodiscard]] const cbr::Terrain& of(const std::string& map);

 private:
  struct Ground {
    std::string map;
    cbr::Terrain terrain;
  };
  std::list<Ground> kept_;  ///< The last asked for first.
};

}  // namespace tacit
