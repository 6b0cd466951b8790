#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "idl/types/config_error.h"
#include "world_server/map/take_map.h"
#include "world_server/world/world.h"

namespace tacit {
namespace {

using Rows = std::vector<std::vector<double>>;

const std::string kMap =
    "MISSION-AREA 30 20\nCONTROL MEASURES:\nPP StartPlace 5 10 0.2\nWALL w 15 0 15 20\n"
    "DOOR d 15 9 15 11\nROOM r 0 0 15 0 15 20 0 20\nOBSTACLE 5 3 1\n";

const std::string kStarts = "starts = [[5.0, 10.0, 0.0]]\n";

/// A map file, gone when this goes.
class MapFile {
 public:
  explicit MapFile(const std::string& text) { std::ofstream(path_) << text; }
  ~MapFile() { std::filesystem::remove(path_); }
  [[nodiscard]] std::string name() const { return path_.string(); }

 private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("tacit-operation-map-" + std::to_string(getpid()) + ".ovl");
};

WorldConfig taken(ScenarioFile& file) {
  WorldConfig world = world_defaults(MissionKind::Operation);
  file.fill(world);
  take_map(world, file);
  check(world);
  return world;
}

WorldConfig taken(const std::string& toml) {
  ScenarioFile file = ScenarioFile::parse("[robots]\ncount = 1\n" + toml, "test.toml");
  return taken(file);
}

/// What a scenario is refused with.
std::string refusal(const std::string& toml) {
  try {
    (void)taken(toml);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return {};
}

std::string with_map(const std::string& more = "") {
  return "[operation]\nmap = '''\n" + kMap + more + "'''\n" + kStarts;
}

TEST(OperationsMap, GivesAreaWallsAndDiscsAndStays) {
  const WorldConfig world = taken(with_map());
  EXPECT_EQ(world.operation.script.map, kMap);
  EXPECT_EQ(world.area.width_m, 30.0);
  EXPECT_EQ(world.area.height_m, 20.0);
  EXPECT_EQ(world.area.walls, (Rows{{15.0, 0.0, 15.0, 9.0}, {15.0, 11.0, 15.0, 20.0}}));
  EXPECT_EQ(world.obstacles.discs, (Rows{{5.0, 3.0, 1.0}}));
}

TEST(OperationsMap, WrittenOutAndReadAgainIsTheSameWorld) {
  WorldConfig world = taken(with_map());
  const std::string once = to_toml(describing(world));
  ScenarioFile file = ScenarioFile::parse(once, "resolved.toml");
  WorldConfig again = taken(file);
  EXPECT_EQ(to_toml(describing(again)), once);
  EXPECT_EQ(World(again, 1).digest(), World(world, 1).digest());
}

TEST(OperationsMap, MayComeFromAFile) {
  const MapFile map(kMap);
  const WorldConfig world = taken("[area]\nmap = \"" + map.name() + "\"\n[operation]\n" + kStarts);
  EXPECT_EQ(world.operation.script.map, kMap);
  EXPECT_EQ(world.area.map, "");
  EXPECT_EQ(world.area.walls.size(), 2U);
}

TEST(OperationsMap, FromAFileWithAnErrorIsRefusedWithTheFilesName) {
  const MapFile map(kMap + "OBSTACLE 1 2\n");
  const std::string said = refusal("[area]\nmap = \"" + map.name() + "\"\n[operation]\n" + kStarts);
  EXPECT_EQ(said.find(map.name() + ":8:"), 0U) << said;
}

TEST(OperationsMap, WithAnErrorIsRefusedWithItsPlace) {
  const std::string said = refusal(with_map("OBSTACLE 1 2\n"));
  EXPECT_EQ(said.find("[operation] map:8:"), 0U) << said;
}

TEST(OperationsMap, AloneSaysHowLargeTheAreaIs) {
  const std::string said = refusal(with_map() + "[area]\nwidth_m = 31.0\n");
  EXPECT_EQ(said.find("[area] width_m: found 31"), 0U) << said;
  EXPECT_EQ(refusal(with_map() + "[area]\nwidth_m = 30.0\n"), "");
}

TEST(OperationsMap, NamedOnTheCommandLineWinsOverTheFilesSize) {
  const MapFile map(kMap);
  ScenarioFile file = ScenarioFile::parse(
      "[robots]\ncount = 1\n[area]\nwidth_m = 300.0\n[operation]\n" + kStarts, "test.toml");
  file.set("area.map", '"' + map.name() + '"', "--map");
  EXPECT_EQ(taken(file).area.width_m, 30.0);
}

}  // namespace
}  // namespace tacit
