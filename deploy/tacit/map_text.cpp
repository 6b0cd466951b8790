#include "deploy/tacit/map_text.h"

#include <cctype>

#include "deploy/tacit/text_canvas.h"
#include "idl/overlay/plan.h"

namespace tacit {
namespace {

constexpr std::string_view kLegend =
    "# wall  + door  : gap  O obstacle  S start  * point  others: an object's colour, a capital "
    "when "
    "it can be moved\n";

char letter_of(const MapObject& object) {
  const auto first = static_cast<unsigned char>(object.colour.empty() ? '?' : object.colour[0]);
  if (std::isalpha(first) == 0) return '?';
  const bool movable = object.mobility == Mobility::Movable;
  return static_cast<char>(movable ? std::toupper(first) : std::tolower(first));
}

}  // namespace

std::string text_picture_of(const OverlayMap& map, int columns) {
  const MapPlan plan = plan_of(map, Doors::Open);
  TextCanvas canvas(plan.ground.size, columns);
  for (const MapObject& object : plan.objects) {
    canvas.disc(object.centre, object.radius_m, letter_of(object));
  }
  for (const std::vector<double>& disc : plan.ground.discs) {
    canvas.disc({disc[0], disc[1]}, disc[2], 'O');
  }
  for (const MapSegment& wall : plan.ground.walls) canvas.line(wall.from, wall.to, '#');
  for (const PlanDoor& gap : plan.gaps) canvas.line(gap.from, gap.to, ':');
  for (const PlanDoor& door : plan.doors) canvas.line(door.from, door.to, '+');
  for (const PlanPoint& point : plan.points) canvas.point(point.at, '*');
  if (plan.ground.start) canvas.point(*plan.ground.start, 'S');
  return canvas.text() + std::string(kLegend);
}

}  // namespace tacit
