#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "world_server/world/terrain.h"

namespace tacit {

/// Which parts of the terrain can lie within a given reach of a point, by table look-up.
class NearMap {
 public:
  /// Indices into the terrain's lists: a superset of what is in reach.
  struct Near {
    std::span<const std::uint16_t> obstacles;
    std::span<const std::uint16_t> walls;
  };

  /// `reach_m` is measured to the surface.
  NearMap(const Terrain& terrain, double reach_m);

  [[nodiscard]] Near near(const WorldVec& p) const;

 private:
  struct Lists {
    std::vector<std::uint32_t> first;  ///< Cell i owns items[first[i]] to items[first[i+1]-1].
    std::vector<std::uint16_t> items;
    [[nodiscard]] std::span<const std::uint16_t> at(std::size_t cell) const;
  };
  [[nodiscard]] std::size_t cell(const WorldVec& p) const;

  double edge_m_;
  std::size_t columns_;
  std::size_t rows_;
  bool bare_;  ///< There is nothing to be near to.
  Lists obstacles_;
  Lists walls_;
};

}  // namespace tacit
