#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "idl/types/ids.h"
#include "idl/types/world_view.h"
#include "world_server/world/digest.h"
#include "world_server/world/sensing/body_grid.h"

namespace tacit {

/// Every mine of a field: it lies somewhere, is held by a robot, or is stored for good.
class Mines {
 public:
  /// Mines at `places_m`, in order of id, in `ground`, an empty grid; `robots` may hold one each.
  Mines(std::span<const WorldVec> places_m, std::size_t robots, const BodyGrid& ground);

  /// Gives `robot`, which holds nothing, the nearest lying mine at most `range_m` from `place_m`,
  /// the lowest id on a tie; 0 when there is none.
  MineId take(std::size_t robot, const WorldVec& place_m, double range_m);
  /// Lays what `robot` holds down at `place_m`.
  MineId put_down(std::size_t robot, const WorldVec& place_m);
  /// Stores what `robot` holds.
  MineId store(std::size_t robot);

  /// How many are still to be stored.
  [[nodiscard]] std::uint32_t left() const { return left_; }
  /// The lying ones, in order of id.
  [[nodiscard]] std::span<const ViewedMine> lying() const { return lying_; }
  /// Over the places of the lying ones.
  [[nodiscard]] const BodyGrid& ground() const { return ground_; }
  void add_to(Digest& digest) const;

 private:
  enum class State : std::uint8_t { Lying, Held, Stored };
  struct Mine {
    WorldVec place_m;  ///< Where it lies or lay last.
    State state = State::Lying;
    std::size_t holder = 0;
  };
  MineId release(std::size_t robot, State state);
  /// Brings the lists of what lies up to date.
  void survey();

  std::vector<Mine> mines_;
  std::vector<MineId> held_;  ///< Per robot; 0 when it holds nothing.
  std::uint32_t left_;
  std::vector<ViewedMine> lying_;
  std::vector<WorldVec> lying_places_m_;
  BodyGrid ground_;
};

}  // namespace tacit
