// Reads any bytes as a map and as an environment script, and holds what is promised of both.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "idl/overlay/change_script.h"
#include "idl/overlay/check.h"
#include "idl/overlay/plan.h"
#include "idl/overlay/reader.h"
#include "idl/overlay/writer.h"

namespace tacit {
namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// A map prints back byte for byte, and anew as what reads back to an equal map.
void hold_round_trip(const OverlayReading& reading, std::string_view text) {
  require(reading.findings.size() <= kMostFindings);
  require(to_text(reading.map) == text);
  const std::string canonical = to_canonical_text(reading.map);
  const OverlayReading again = read_overlay(canonical);
  require(again.map == reading.map);
  require(to_canonical_text(again.map) == canonical);
  require(has_errors(again.findings) == has_errors(reading.findings));
}

void hold_plan(const OverlayMap& map) {
  const MapFindings findings = check(map);
  require(findings.size() <= kMostFindings);
  for (const MapFinding& finding : findings) (void)to_text(finding, "map");
  for (const Doors doors : {Doors::Open, Doors::Closed}) {
    const MapPlan plan = plan_of(map, doors);
    for (const PlanPoint& point : plan.points) (void)room_at(plan.rooms, point.at);
  }
  (void)extent_of(map);
}

void hold_script(std::string_view text) {
  const ChangeReading reading = read_changes(text);
  require(reading.findings.size() <= kMostFindings);
  const ChangeReading again = read_changes(to_text(reading.script));
  require(again.findings.empty());
  require(again.script == reading.script);
}

}  // namespace
}  // namespace tacit

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const tacit::OverlayReading reading = tacit::read_overlay(text);
  tacit::hold_round_trip(reading, text);
  tacit::hold_plan(reading.map);
  tacit::hold_script(text);
  return 0;
}
