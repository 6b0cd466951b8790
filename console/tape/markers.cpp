#include "console/tape/markers.h"

namespace tacit {
namespace {

/// Writes CDR: little-endian, numbers aligned to their size from behind the first 4 bytes.
class CdrWriter {
 public:
  template <class Number>
  CdrWriter& number(Number value) {
    while ((bytes_.size() - kEncapsulation) % sizeof value != 0) bytes_.push_back(0);
    const auto* const raw = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), raw, raw + sizeof value);
    return *this;
  }
  CdrWriter& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
    return *this;
  }
  CdrWriter& count(std::size_t count) { return number(static_cast<std::uint32_t>(count)); }
  [[nodiscard]] std::vector<std::uint8_t> bytes() && { return std::move(bytes_); }

 private:
  static constexpr std::size_t kEncapsulation = 4;
  std::vector<std::uint8_t> bytes_{0, 1, 0, 0};
};

void write(CdrWriter& out, const Marker::Point& point) {
  out.number(point.x).number(point.y).number(point.z);
}

void write(CdrWriter& out, const Marker::Paint& paint) {
  out.number(paint.r).number(paint.g).number(paint.b).number(paint.a);
}

void write_header(CdrWriter& out, std::uint64_t time_ns) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  out.number(static_cast<std::int32_t>(time_ns / kSecond));
  out.number(static_cast<std::uint32_t>(time_ns % kSecond)).text("world");
}

void write(CdrWriter& out, const Marker& marker) {
  out.text(marker.group).number(marker.id).number(static_cast<std::int32_t>(marker.type));
  out.number(static_cast<std::int32_t>(marker.action));
  write(out, marker.position);
  out.number(0.0).number(0.0).number(marker.turn_sin).number(marker.turn_cos);
  write(out, marker.scale);
  write(out, marker.paint);
  out.number(std::int32_t{0}).number(std::uint32_t{0}).number(std::uint8_t{0});
  out.count(marker.points.size());
  for (const Marker::Point& point : marker.points) write(out, point);
  out.count(marker.paints.size());
  for (const Marker::Paint& paint : marker.paints) write(out, paint);
  out.text(marker.text).text("").number(std::uint8_t{0});
}

}  // namespace

std::vector<std::uint8_t> marker_array(std::span<const Marker> markers, std::uint64_t time_ns) {
  CdrWriter out;
  out.count(markers.size());
  for (const Marker& marker : markers) {
    write_header(out, time_ns);
    write(out, marker);
  }
  return std::move(out).bytes();
}

std::string_view marker_array_schema() {
  return R"(visualization_msgs/Marker[] markers
================================================================================
MSG: visualization_msgs/Marker
int32 ARROW=0
int32 CUBE=1
int32 SPHERE=2
int32 CYLINDER=3
int32 LINE_STRIP=4
int32 LINE_LIST=5
int32 CUBE_LIST=6
int32 SPHERE_LIST=7
int32 POINTS=8
int32 TEXT_VIEW_FACING=9
int32 MESH_RESOURCE=10
int32 TRIANGLE_LIST=11
int32 ADD=0
int32 MODIFY=0
int32 DELETE=2
int32 DELETEALL=3
std_msgs/Header header
string ns
int32 id
int32 type
int32 action
geometry_msgs/Pose pose
geometry_msgs/Vector3 scale
std_msgs/ColorRGBA color
builtin_interfaces/Duration lifetime
bool frame_locked
geometry_msgs/Point[] points
std_msgs/ColorRGBA[] colors
string text
string mesh_resource
bool mesh_use_embedded_materials
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
================================================================================
MSG: builtin_interfaces/Duration
int32 sec
uint32 nanosec
================================================================================
MSG: geometry_msgs/Pose
geometry_msgs/Point position
geometry_msgs/Quaternion orientation
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
================================================================================
MSG: std_msgs/ColorRGBA
float32 r
float32 g
float32 b
float32 a
)";
}

}  // namespace tacit
