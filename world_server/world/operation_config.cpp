#include "world_server/world/operation_config.h"

#include <array>
#include <string_view>

#include "world_server/world/refuse.h"

namespace tacit {
namespace {

constexpr std::array<std::string_view, 2> kProceeds{"at_once", "ask"};
constexpr Range kReach{0.0, 1000.0};

void describe_signal(SignalConfig& signal, ParameterVisitor& v) {
  v.section("signal", "How robots hear what others say.");
  v.number("range_m", signal.range_m, {0, 100000},
           {"m", "From how far. [ours: MissionLab's radio reaches everybody]"});
  v.number("missed_share", signal.missed_share, {0, 1},
           {"", "Chance that a robot in range misses a signal. [ours]"});
  v.flag("blocked_by_walls", signal.blocked_by_walls,
         {"", "Whether walls keep signals out. [MissionLab: no]"});
}

void describe_reach(OperationReachConfig& reach, ParameterVisitor& v) {
  v.section("reach", "What robots can do with what is how near and not behind a wall.");
  v.number("pick_up_m", reach.pick_up_m, kReach,
           {"m", "Of picking an object up, to its rim. [ours]"});
  v.number("drop_m", reach.drop_m, kReach,
           {"m", "An object dropped this near to a container's rim is stored in it. [ours]"});
  v.number("test_m", reach.test_m, kReach, {"m", "Of testing an object, to its rim. [ours]"});
  v.number("mark_m", reach.mark_m, kReach,
           {"m", "Of marking a doorway, to the middle of its opening. [ours: from beside it]"});
  v.number("intercept_m", reach.intercept_m, kReach,
           {"m", "Of disabling an enemy, centre to centre. [ours: as in foraging]"});
}

void describe_senses(OperationConfig& config, ParameterVisitor& v) {
  v.section("map_senses", "What robots make of the walls around.");
  v.number("doorway_range_m", config.doorway_range_m, {0, 1000},
           {"m", "Of telling a doorway. [ours]"});
  v.number("point_reach_m", config.point_reach_m, {0, 1000},
           {"m", "A robot this near to a point of the map has reached it. [ours]"});
  v.section("exposure", "When a robot of the team counts as seen by an enemy.");
  v.number("range_m", config.exposure_range_m, {0, 1000},
           {"m", "In line of sight of a red robot this near. [ours]"});
  v.section("operator", "The person at the control station.");
  v.choice("proceed", config.proceed, kProceeds,
           {"",
            "Whether a robot that waits for the word to go on has it at once, or must be given it. "
            "[ours: a run without a person does not wait]"});
}

}  // namespace

void describe(OperationConfig& config, ParameterVisitor& visitor) {
  describe(config.script, visitor);
  describe_signal(config.signal, visitor);
  describe_reach(config.reach, visitor);
  describe_senses(config, visitor);
}

void check(const OperationConfig& config, std::int64_t robots) {
  const OperationScript& script = config.script;
  const std::string count = std::to_string(robots);
  refuse(script.extra_count >= robots,
         "[operation] extra_count = " + std::to_string(script.extra_count) + ": of " + count +
             " robots none is left for the team; wanted fewer");
  refuse(static_cast<std::int64_t>(script.starts.size()) != robots,
         "[operation] starts: found " + std::to_string(script.starts.size()) +
             " rows, wanted one for each of the " + count + " robots");
}

}  // namespace tacit
