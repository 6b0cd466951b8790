#pragma once

namespace tacit {

/// What stands for "infinite" inside a safety margin: so strong that it outweighs every other push
/// of a sum, yet finite, so that several such pushes still add up to a direction.
inline constexpr double kInfiniteRepulsion = 20.0;

/// How strongly something `range_m` away pushes off: 0 from `reach_m` outwards, growing linearly to
/// 1 at `margin_m` (Arkin 1989, avoid-static-obstacle), and `kInfiniteRepulsion` from there
/// inwards (MissionLab). Needs margin_m < reach_m.
[[nodiscard]] constexpr double repulsion(double range_m, double reach_m, double margin_m) {
  if (range_m >= reach_m) return 0.0;
  if (range_m <= margin_m) return kInfiniteRepulsion;
  return (reach_m - range_m) / (reach_m - margin_m);
}

}  // namespace tacit
