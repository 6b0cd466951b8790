#include "idl/overlay/overlay.h"

#include <algorithm>

#include "idl/overlay/tokens.h"

namespace tacit {

bool operator==(const OverlayMap& a, const OverlayMap& b) {
  return std::equal(
      a.statements.begin(), a.statements.end(), b.statements.begin(), b.statements.end(),
      [](const MapStatement& x, const MapStatement& y) { return x.content == y.content; });
}

std::optional<MapSize> mission_area(const OverlayMap& map) {
  for (const MapStatement& statement : map.statements) {
    const auto* header = std::get_if<MapHeader>(&statement.content);
    if (header != nullptr && header->kind == HeaderKind::MissionArea) {
      return MapSize{header->numbers.at(0), header->numbers.at(1)};
    }
  }
  return std::nullopt;
}

bool is_start_place(std::string_view name) {
  if (name.ends_with('*')) {
    name.remove_suffix(1);
  }
  return capitals(name) == "STARTPLACE";
}

std::optional<MapPoint> start_place(const OverlayMap& map) {
  for (const MapStatement& statement : map.statements) {
    const auto* shape = std::get_if<MapShape>(&statement.content);
    const bool start = shape != nullptr &&
                       (shape->kind == ShapeKind::StartPoint ||
                        (shape->kind == ShapeKind::PassagePoint && is_start_place(shape->name)));
    if (start && !shape->points.empty()) {
      return shape->points.front();
    }
  }
  return std::nullopt;
}

}  // namespace tacit
