#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "deploy/lockstep/setup.h"
#include "idl/types/config_error.h"
#include "world_server/world/world.h"

namespace tacit {
namespace {

/// A map file, gone when this goes. A wall parts the area; its door is 2 m wide.
class MapFile {
 public:
  explicit MapFile(const std::string& more = "") {
    std::ofstream(path_) << "MISSION-AREA 30 20\nCONTROL MEASURES:\nPP StartPlace 5 10 0.2\n"
                            "WALL w 15 0 15 20\nDOOR d 15 9 15 11\nOBSTACLE 5 3 1\n"
                         << more;
  }
  ~MapFile() { std::filesystem::remove(path_); }
  [[nodiscard]] std::string name() const { return path_.string(); }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("tacit-map-" + std::to_string(getpid()) + ".ovl");
};

Setup setup_of(const std::string& toml, const std::string& map) {
  ScenarioFile file = ScenarioFile::parse(toml, "test.toml");
  file.set("area.map", '"' + map + '"', "--map");
  return read_setup(file);
}

const std::string kOneRobot = "[robots]\ncount = 1\n[enemies]\nstrategy = 0\n";

const std::string kOneForager = "[robots]\ncount = 1\n";

/// How far east one robot comes in 15 s that begins at 5, `y_m` and goes east.
double east_m(const std::string& y_m, const std::string& toml = "") {
  const MapFile map;
  ScenarioFile file = ScenarioFile::parse(kOneRobot + toml, "test.toml");
  file.set("area.map", '"' + map.name() + '"', "--map");
  file.set("target.y_m", y_m, "--set");
  World world(read_setup(file).world, 1);
  for (int i = 0; i < 150; ++i) {
    const std::vector<Command> command{{RobotId{1}, world.tick(), {2.0, 0.0}, 0.0}};
    (void)world.step(command);
  }
  WorldView view;
  world.view(view);
  return view.robots.at(0).pose.position_m.x();
}

TEST(Map, LetsARobotThroughAnOpenDoor) { EXPECT_GT(east_m("10.0"), 25.0); }

TEST(Map, StopsARobotAtAWallBesideTheDoor) {
  EXPECT_LT(east_m("15.0"), 15.0);
  EXPECT_GT(east_m("15.0"), 14.5);
}

TEST(Map, StopsARobotAtAClosedDoor) {
  EXPECT_LT(east_m("10.0", "[area]\ndoors = \"closed\"\n"), 15.0);
}

/// How many mines a robot at the start place sees.
int mines_seen(const std::string& toml, const std::string& mine) {
  const MapFile map("OBJECT " + mine + " 0.5 Movable orange\n");
  const World world(
      setup_of("[scenario]\nmission = \"forage\"\n" + kOneForager + toml, map.name()).world, 1);
  const auto& seen = world.percepts()[0].sightings;
  return static_cast<int>(std::count_if(seen.begin(), seen.end(), [](const Sighting& sighting) {
    return sighting.kind == Kind::Mine;
  }));
}

TEST(Map, LetsARobotSeeThroughADoorway) { EXPECT_EQ(mines_seen("", "20 10"), 1); }

TEST(Map, LetsNoRobotSeeThroughAWall) { EXPECT_EQ(mines_seen("", "20 16"), 0); }

TEST(Map, LetsNoRobotSeeThroughAClosedDoor) {
  EXPECT_EQ(mines_seen("[area]\ndoors = \"closed\"\n", "20 10"), 0);
}

TEST(Map, WrittenOutIsTheSameWorldWithoutTheMap) {
  std::string resolved;
  tacit::Setup with_map;
  {
    const MapFile map;
    with_map = setup_of(kOneRobot, map.name());
    resolved = to_toml(describing(with_map));
  }
  ScenarioFile file = ScenarioFile::parse(resolved, "resolved.toml");
  const auto without = read_setup(file);
  EXPECT_EQ(without.world.area.walls, with_map.world.area.walls);
  EXPECT_EQ(World(without.world, 1).digest(), World(with_map.world, 1).digest());
}

TEST(Map, GivesAreaTargetWallsAndDiscsAndIsNeededNoMore) {
  const MapFile map;
  const auto setup = setup_of("[area]\nwidth_m = 300.0\n", map.name());
  EXPECT_EQ(setup.world.area.width_m, 30.0);
  EXPECT_EQ(setup.world.target.x_m, 5.0);
  EXPECT_EQ(setup.world.area.walls.size(), 2U);
  EXPECT_EQ(setup.world.obstacles.discs, (std::vector<std::vector<double>>{{5.0, 3.0, 1.0}}));
  EXPECT_EQ(setup.world.obstacles.coverage_percent, 0.0);
  EXPECT_EQ(setup.world.area.map, "");
}

TEST(Map, NamedInTheScenarioLeavesWhatTheScenarioSays) {
  const MapFile map;
  ScenarioFile file = ScenarioFile::parse(
      "[area]\nmap = \"" + map.name() + "\"\n[target]\nx_m = 20.0\n", "test.toml");
  const auto setup = read_setup(file);
  EXPECT_EQ(setup.world.target.x_m, 20.0);
  EXPECT_EQ(setup.world.target.y_m, 10.0);
}

TEST(Map, GivesMinesToAForagingTeam) {
  const MapFile map("OBJECT 20 10 0.5 Movable orange\n");
  const auto setup = setup_of("[scenario]\nmission = \"forage\"\n", map.name());
  EXPECT_EQ(setup.world.forage.mines.places, (std::vector<std::vector<double>>{{20.0, 10.0}}));
  EXPECT_EQ(setup.world.forage.mines.count, 0);
  EXPECT_EQ(setup.world.forage.base.x_m, 5.0);
}

TEST(Map, ThatIsNotThereIsRefused) {
  EXPECT_THROW((void)setup_of("", "/nowhere.ovl"), ConfigError);
}

TEST(Map, WithAnErrorIsRefusedWithItsPlace) {
  const MapFile map("OBSTACLE 1 2\n");
  try {
    (void)setup_of("", map.name());
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find(":7:13: error: found the end of OBSTACLE"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace tacit
