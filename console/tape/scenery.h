#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tacit {

/// What of a scenario does not move, world frame; as far as the scenario says it. Obstacles that
/// the world draws by chance are not in it.
struct Scenery {
  struct Place {
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.0;
  };

  double tick_s = 0.1;  ///< Simulated time per tick.
  double width_m = 0.0;
  double height_m = 0.0;
  double robot_radius_m = 0.2;
  bool border_walls = false;
  std::vector<std::vector<double>> walls;  ///< Rows of x1, y1, x2, y2.
  std::vector<std::vector<double>> discs;  ///< Rows of x, y, r.
  std::optional<Place> focus;              ///< The target or the base.
  std::string map;                         ///< Text of an operation's map (.ovl).
};

/// Takes it from the text of a resolved scenario. What is missing there keeps its default. Throws
/// ConfigError when the text, called `name`, is not TOML.
[[nodiscard]] Scenery scenery_of(std::string_view scenario_toml, const std::string& name);

}  // namespace tacit
