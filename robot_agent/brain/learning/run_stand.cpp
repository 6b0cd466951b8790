#include "robot_agent/brain/learning/run_stand.h"

#include "idl/types/shortest.h"

namespace tacit {
namespace {

std::string whole(std::uint64_t value) { return std::to_string(value); }

std::string pair(const OdometryVec& place_m) {
  return json_number(place_m.x()) + "," + json_number(place_m.y());
}

std::string fixes(const QuarryTrack::Record& track) {
  std::string text;
  for (const QuarryTrack::Fix& fix : track.fixes) {
    if (!text.empty()) text += ',';
    text += "[" + pair(fix.quarry_m) + "," + pair(fix.self_m) + "]";
  }
  return text;
}

}  // namespace

std::string to_line(const RunStand& stand) {
  std::string line = R"({"format":"tacit-memory","version":1,"learner":")" + stand.learner +
                     R"(","role":")" + stand.role + R"(","state":")" + stand.state +
                     R"(","entered":)" + whole(stand.entered.tick) + R"(,"entered_at":[)" +
                     pair(stand.entered.pose.position_m) + "," +
                     json_number(stand.entered.pose.heading.cos) + "," +
                     json_number(stand.entered.pose.heading.sin) + R"(],"disabled":)" +
                     (stand.disabled ? "true" : "false");
  if (stand.last) {
    line += R"(,"last":{"state":)" + whole(stand.last->state) + R"(,"action":)" +
            whole(stand.last->action) + R"(,"tick":)" + whole(stand.last_tick) + "}";
  }
  line += R"(,"triggers":)" + whole(stand.triggers) + R"(,"chance":)" + whole(stand.chance);
  if (stand.perception.base_m) line += R"(,"base_m":[)" + pair(*stand.perception.base_m) + "]";
  const QuarryTrack::Record& track = stand.perception.track;
  return line + R"(,"track":{"count":)" + whole(track.count) + R"(,"tick":)" +
         whole(track.last_tick) + R"(,"fixes":[)" + fixes(track) + "]}}";
}

}  // namespace tacit
