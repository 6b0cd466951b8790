#include "world_server/world/forage_config.h"

#include <array>
#include <string_view>

#include "world_server/world/refuse.h"
#include "world_server/world/world_config.h"

namespace tacit {
namespace {

constexpr std::array<std::string_view, 2> kPlaceColumns{"x", "y"};
constexpr std::array<std::string_view, 3> kLayouts{"scattered", "clusters", "ring"};

void describe_base(BaseConfig& base, ParameterVisitor& v) {
  v.section("base", "The storage area, where mines are brought.");
  v.number("x_m", base.x_m, {0, 100000}, {"m", "Position from the west border. [ours]"});
  v.number("y_m", base.y_m, {0, 100000}, {"m", "Position from the south border. [ours]"});
  v.number("radius_m", base.radius_m, {0, 100}, {"m", "Apparent radius. [MissionLab]"});
}

void describe_mines(MineConfig& mines, ParameterVisitor& v) {
  v.section("mines", "What is to be collected.");
  v.integer("count", mines.count, {0, 1000},
            {"", "How many are laid by chance. [ours: the paper is silent]"});
  v.choice("layout", mines.layout, kLayouts,
           {"",
            "Anywhere, in discs round random places, or near the border. [paper: number, position "
            "and proximity of mines varied]"});
  v.integer("clusters", mines.clusters, {1, 1000}, {"", "Discs that mines lie in. [ours]"});
  v.number("cluster_radius_m", mines.cluster_radius_m, {0, 100000},
           {"m", "Radius of such a disc. [ours]"});
  v.number("ring_inset_m", mines.ring_inset_m, {0, 100000},
           {"m", "Distance of a ring of mines from the border. [ours]"});
  v.number("keep_from_base_m", mines.keep_from_base_m, {0, 100000},
           {"m", "No mine is laid nearer to the base than this. [ours: a way to go]"});
  v.number("radius_m", mines.radius_m, {0.01, 100}, {"m", "Apparent radius. [MissionLab]"});
  v.integer("seed", mines.seed, {0, 9e15},
            {"", "Seed of their places alone; 0 follows the run's seed. [ours]"});
  v.rows("places", mines.places, kPlaceColumns, {-1e5, 1e5},
         {"m", "Mines at given places, beside those laid by chance. [ours]"});
}

void describe_dangers(ForageConfig& forage, ParameterVisitor& v) {
  v.section("mud", "Terrain that robots get stuck in without seeing it.");
  v.number("per_tick", forage.mud.per_tick, {0, 1},
           {"",
            "Chance that a robot gets stuck in a tick. [paper: a random occurrence for each robot; "
            "rate ours]"});
  HunterConfig& hunters = forage.hunters;
  v.section("hunters", "Mobile enemies that hide outside and come to disable robots.");
  v.integer("count", hunters.count, {0, 100}, {"", "How many. [paper: one]"});
  v.number("speed_mps", hunters.speed_mps, {0, 1000},
           {"m/s", "[ours: faster than a robot goes about its work]"});
  v.number("radius_m", hunters.radius_m, {0.01, 100}, {"m", "Body radius. [MissionLab]"});
  v.number("contact_m", hunters.contact_m, {0.01, 1000},
           {"m", "It disables a robot this near, centre to centre. [paper: by touch]"});
  v.integer("min_wait_ticks", hunters.min_wait_ticks, {0, 1e9},
            {"ticks", "Shortest time in hiding. [ours]"});
  v.integer("max_wait_ticks", hunters.max_wait_ticks, {0, 1e9},
            {"ticks", "Longest time in hiding. [ours]"});
  v.number("avoid_reach_m", hunters.avoid_reach_m, {0, 1000},
           {"m", "Distance from a surface at which it starts to repel. [MissionLab]"});
  v.number("avoid_margin_m", hunters.avoid_margin_m, {0, 1000},
           {"m", "Distance from a surface at which it repels fully. [MissionLab]"});
}

void describe_reach(ForageConfig& forage, ParameterVisitor& v) {
  ReachConfig& reach = forage.reach;
  v.section("reach", "What robots can do with what is how near, centre to centre.");
  v.number("pick_up_m", reach.pick_up_m, {0.01, 1000}, {"m", "Of picking a mine up. [MissionLab]"});
  v.number("drop_m", reach.drop_m, {0.01, 1000},
           {"m", "A mine dropped this near to the base is stored. [MissionLab]"});
  v.number("intercept_m", reach.intercept_m, {0.01, 1000},
           {"m", "Of destroying an enemy. [ours: beyond its touch, \"safely\" (paper)]"});
  v.number("aid_m", reach.aid_m, {0.01, 1000},
           {"m", "Of getting a disabled robot going again. [paper: by touch]"});
  v.flag(
      "revival_needs_aid", reach.revival_needs_aid,
      {"",
       "Whether a robot must mean to help, as Mechanics do, or any robot's touch will do. [ours: "
       "the paper says both]"});
  v.section("end", "When a mission counts as failed.");
  v.integer("cap_ticks", forage.cap_ticks, {1, 1e9},
            {"ticks", "It ends here and scores this. [paper: 1,000,000 iterations]"});
}

}  // namespace

void describe(ForageConfig& config, ParameterVisitor& visitor) {
  describe_base(config.base, visitor);
  describe_mines(config.mines, visitor);
  describe_dangers(config, visitor);
  describe_reach(config, visitor);
}

void check(const ForageConfig& config, const AreaConfig& area) {
  refuse(config.mines.count == 0 && config.mines.places.empty(),
         "[mines] count = 0: there are no mines; wanted at least 1, or some in places");
  refuse(config.hunters.min_wait_ticks > config.hunters.max_wait_ticks,
         "[hunters] min_wait_ticks is larger than max_wait_ticks; wanted min <= max");
  refuse(config.hunters.avoid_margin_m >= config.hunters.avoid_reach_m,
         "[hunters] avoid_margin_m is not below avoid_reach_m; wanted margin < reach");
  for (const auto& place : config.mines.places) {
    refuse(!area.holds(place[0], place[1]),
           "[mines] places holds a point outside the area; wanted all inside");
  }
}

}  // namespace tacit
