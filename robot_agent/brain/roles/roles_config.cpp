#include "robot_agent/brain/roles/roles_config.h"

#include <string>

#include "idl/types/config_error.h"
#include "idl/types/shortest.h"

namespace tacit {
namespace {

constexpr Range kRanges{0.0, 1000.0};
constexpr Range kGains{0.0, 1000.0};

struct Limit {
  const char* near_key;
  double near_m;
  const char* reach_key;
  double reach_m;
};

void describe_ranges(RolesConfig& config, ParameterVisitor& visitor) {
  visitor.number("near_mine_m", config.near_mine_m, kRanges,
                 {"m",
                  "From this range inwards a Forager stops to take a mine up [ours: MissionLab's "
                  "0.1 m cannot be had when the mine lies under a disabled robot]."});
  visitor.number(
      "pick_up_reach_m", config.pick_up_reach_m, kRanges,
      {"m", "Range beyond which it gives a pick-up up [ours: the world's pick-up reach]."});
  visitor.number("near_base_m", config.near_base_m, kRanges,
                 {"m",
                  "From this range to the base inwards it stops to drop its mine [ours: a little "
                  "inside the world's drop reach]."});
  visitor.number("drop_reach_m", config.drop_reach_m, kRanges,
                 {"m", "Range beyond which it gives a drop up [ours: the world's drop reach]."});
  visitor.number("near_disabled_m", config.near_disabled_m, kRanges,
                 {"m",
                  "From this range inwards a Mechanic tries to aid while it moves on until it "
                  "touches [ours: bodies keep the centres apart, so that no range is surely "
                  "reached]."});
}

void describe_gains(RolesConfig& config, ParameterVisitor& visitor) {
  visitor.number("wander_gain", config.wander_gain, kGains,
                 {"", "Weight of Noise in states that search [MissionLab]."});
  visitor.number("approach_gain", config.approach_gain, kGains,
                 {"", "Weight of MoveTo in states that approach [MissionLab]."});
  visitor.number("approach_noise_gain", config.approach_noise_gain, kGains,
                 {"",
                  "Weight of Noise in states that approach [ours: 0.1, as MissionLab has it where "
                  "robots meet; gets a robot round what it runs straight into]."});
  visitor.number("pursuit_gain", config.pursuit_gain, kGains,
                 {"",
                  "Weight of PursueEnemy [ours: twice the base speed, or a hunter, faster than "
                  "that, is never caught]."});
  visitor.number("avoid_obstacles_gain", config.avoid_obstacles_gain, kGains,
                 {"", "Weight of AvoidObstacles in every state of motion [MissionLab]."});
  visitor.number("avoid_teammates_gain", config.avoid_teammates_gain, kGains,
                 {"",
                  "Weight of AvoidSoldiers in every state of motion, against able teammates "
                  "[ours: as of obstacles; below the pull, or one robot could bar the base]."});
}

}  // namespace

void describe(RolesConfig& config, ParameterVisitor& visitor) {
  visitor.section("brain.roles", "The automata of Forager, Soldier and Mechanic.");
  describe_ranges(config, visitor);
  describe_gains(config, visitor);
  visitor.text(
      "mission", config.mission,
      {"",
       "A mission in the Configuration Description Language; its robots Forager, Soldier "
       "and Mechanic say what those roles do, in place of all of the above [MissionLab]."});
}

void check(const RolesConfig& config) {
  for (const Limit& limit :
       {Limit{"near_mine_m", config.near_mine_m, "pick_up_reach_m", config.pick_up_reach_m},
        Limit{"near_base_m", config.near_base_m, "drop_reach_m", config.drop_reach_m}}) {
    if (limit.near_m <= limit.reach_m) continue;
    throw ConfigError(std::string("brain.roles.") + limit.near_key + " is " +
                      shortest(limit.near_m) + " m, wanted at most brain.roles." + limit.reach_key +
                      ", which is " + shortest(limit.reach_m) + " m");
  }
}

}  // namespace tacit
