#include <gtest/gtest.h>
#include <unistd.h>

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

/// How far east one robot comes in 15 s that begins at the start place and goes east.
double east_m(const std::string& toml) {
  const MapFile map;
  World world(setup_of(kOneRobot + toml, map.name()).world, 1);
  for (int i = 0; i < 150; ++i) {
    const std::vector<Command> command{{RobotId{1}, world.tick(), {2.0, 0.0}, 0.0}};
    (void)world.step(command);
  }
  WorldView view;
  world.view(view);
  return view.robots.at(0).pose.position_m.x();
}

TEST(Map, LetsARobotThroughAnOpenDoor) { EXPECT_GT(east_m(""), 25.0); }

TEST(Map, StopsARobotAtAClosedDoor) { EXPECT_LT(east_m("[area]\ndoors = \"closed\"\n"), 15.0); }

TEST(Map, GivesAreaTargetWallsAndDiscsAndIsNeededNoMore) {
  const MapFile map;
  const Setup setup = setup_of("[area]\nwidth_m = 300.0\n", map.name());
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
  const Setup setup = read_setup(file);
  EXPECT_EQ(setup.world.target.x_m, 20.0);
  EXPECT_EQ(setup.world.target.y_m, 10.0);
}

TEST(Map, GivesMinesToAForagingTeam) {
  const MapFile map("OBJECT 20 10 0.5 Movable orange\n");
  const Setup setup = setup_of("[scenario]\nmission = \"forage\"\n", map.name());
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
