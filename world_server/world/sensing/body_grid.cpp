#include "world_server/world/sensing/body_grid.h"

#include <algorithm>
#include <cmath>

namespace tacit {
namespace {

std::size_t clamped_cell(double x, double inverse_edge, std::size_t count) {
  const double i = x * inverse_edge;
  return i <= 0.0 ? 0 : std::min(count - 1, static_cast<std::size_t>(i));
}

}  // namespace

BodyGrid::BodyGrid(double width_m, double height_m, double usual_range_m)
    : width_m_(width_m),
      height_m_(height_m),
      smallest_edge_m_(std::max(0.5 * usual_range_m, 0.5)) {}

std::size_t BodyGrid::column(double x) const { return clamped_cell(x, inverse_edge_, columns_); }

std::size_t BodyGrid::row(double y) const { return clamped_cell(y, inverse_edge_, rows_); }

void BodyGrid::resize_cells(std::size_t bodies) {
  const double per_body_m =
      std::sqrt(width_m_ * height_m_ / static_cast<double>(std::max<std::size_t>(bodies, 1)));
  const double edge_m = std::max(smallest_edge_m_, per_body_m);
  inverse_edge_ = 1.0 / edge_m;
  columns_ = static_cast<std::size_t>(std::ceil(width_m_ / edge_m));
  rows_ = static_cast<std::size_t>(std::ceil(height_m_ / edge_m));
}

void BodyGrid::rebuild(std::span<const WorldVec> positions_m) {
  resize_cells(positions_m.size());
  first_.assign(columns_ * rows_ + 1, 0);
  cell_of_.resize(positions_m.size());
  bodies_.resize(positions_m.size());
  places_m_.resize(positions_m.size());
  for (std::size_t i = 0; i < positions_m.size(); ++i) {
    const std::size_t cell = row(positions_m[i].y()) * columns_ + column(positions_m[i].x());
    cell_of_[i] = static_cast<std::uint32_t>(cell);
    ++first_[cell + 1];
  }
  for (std::size_t cell = 1; cell < first_.size(); ++cell) {
    first_[cell] += first_[cell - 1];
  }
  // Filling from the back leaves first_ one cell too far on and each cell in order of index.
  for (std::size_t i = positions_m.size(); i-- > 0;) {
    const std::uint32_t at = --first_[cell_of_[i] + 1];
    bodies_[at] = static_cast<std::uint32_t>(i);
    places_m_[at] = positions_m[i];
  }
  std::rotate(first_.begin(), first_.begin() + 1, first_.end());
  first_.back() = static_cast<std::uint32_t>(positions_m.size());
}

}  // namespace tacit
