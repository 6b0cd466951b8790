#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "idl/types/frames.h"

namespace tacit {

/// Moving bodies sorted into square cells, so that "who is near" costs what is near.
///
/// Made anew every tick by a counting sort; cells are sized so that there are about as many as
/// bodies, and none is much smaller than the range asked for.
class BodyGrid {
 public:
  BodyGrid(double width_m, double height_m, double usual_range_m);

  void rebuild(std::span<const WorldVec> positions_m);

  /// Calls `visit(index, place_m)` for every body whose cell meets the square of half-edge
  /// `range_m` round `p`: a superset of those within `range_m`, in an order fixed by the positions.
  template <class Visit>
  void near(const WorldVec& p, double range_m, Visit visit) const {
    const std::size_t first_column = column(p.x() - range_m);
    const std::size_t last_column = column(p.x() + range_m);
    const std::size_t last_row = row(p.y() + range_m);
    for (std::size_t r = row(p.y() - range_m); r <= last_row; ++r) {
      const std::uint32_t begin = first_[r * columns_ + first_column];
      const std::uint32_t end = first_[r * columns_ + last_column + 1];
      for (std::uint32_t i = begin; i < end; ++i) {
        visit(std::size_t{bodies_[i]}, places_m_[i]);
      }
    }
  }

 private:
  void resize_cells(std::size_t bodies);
  [[nodiscard]] std::size_t column(double x) const;
  [[nodiscard]] std::size_t row(double y) const;

  double width_m_;
  double height_m_;
  double smallest_edge_m_;
  double inverse_edge_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> cell_of_;
  std::vector<std::uint32_t> bodies_;
  std::vector<WorldVec> places_m_;  ///< Beside `bodies_`, so that a visit reads memory in order.
};

}  // namespace tacit
