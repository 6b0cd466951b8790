#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tacit {

/// A figure in a 3D view, as visualization_msgs/Marker of ROS 2 has it.
struct Marker {
  enum class Type : std::int32_t {
    Arrow = 0,
    Cylinder = 3,
    LineList = 5,
    SphereList = 7,
    Text = 9
  };
  enum class Action : std::int32_t { Add = 0, Delete = 2 };
  struct Point {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
  };
  struct Paint {
    float r = 1.0F;
    float g = 1.0F;
    float b = 1.0F;
    float a = 1.0F;
  };

  std::string group;  ///< "robots"; with `id` it names the figure, which a later one replaces.
  std::int32_t id = 0;
  Type type = Type::SphereList;
  Action action = Action::Add;
  Point position;         ///< [m]
  double turn_cos = 1.0;  ///< Of half the angle by which it is turned about z.
  double turn_sin = 0.0;
  Point scale{1.0, 1.0, 1.0};  ///< [m]
  Paint paint;
  std::vector<Point> points;
  std::vector<Paint> paints;  ///< Of each point; none: all as `paint`.
  std::string text;
};

/// The CDR bytes of a visualization_msgs/msg/MarkerArray of these in the frame "world".
[[nodiscard]] std::vector<std::uint8_t> marker_array(std::span<const Marker> markers,
                                                     std::uint64_t time_ns);

inline constexpr std::string_view kMarkerArray = "visualization_msgs/msg/MarkerArray";
/// Its schema in ROS 2 message text.
[[nodiscard]] std::string_view marker_array_schema();

}  // namespace tacit
