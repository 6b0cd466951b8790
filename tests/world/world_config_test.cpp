#include "world_server/world/world_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

TEST(WorldConfigCheck, AcceptsTheDefaults) { EXPECT_NO_THROW(check(WorldConfig{})); }

TEST(WorldConfigCheck, NamesRadiiOutOfOrder) {
  WorldConfig config;
  config.obstacles.min_radius_m = 6.0;
  EXPECT_EQ(refusal(config),
            "[obstacles] min_radius_m is larger than max_radius_m; wanted min <= max");
}

TEST(WorldConfigCheck, NamesAMarginAsLargeAsTheReach) {
  WorldConfig config;
  config.enemies.avoid_margin_m = config.enemies.avoid_reach_m;
  EXPECT_EQ(refusal(config),
            "[enemies] avoid_margin_m is not below avoid_reach_m; wanted margin < reach");
}

TEST(WorldConfigCheck, NamesATargetOutsideTheArea) {
  WorldConfig config;
  config.target.x_m = config.area.width_m + 1.0;
  EXPECT_EQ(refusal(config), "[target] x_m, y_m lie outside the area; wanted a point in it");
}

TEST(WorldConfigCheck, NamesARingThatReachesOutside) {
  WorldConfig config;
  config.target.y_m = 5.0;
  const std::string text =
      "[robots] ring_radius_m reaches outside the area; wanted the whole ring in it";
  EXPECT_EQ(refusal(config), text);
  config.robots.start = "scattered";
  EXPECT_EQ(refusal(config), "");
}

TEST(WorldConfigCheck, NamesAGivenObstacleWithoutRadius) {
  WorldConfig config;
  config.obstacles.discs = {{10.0, 10.0, 1.0}, {20.0, 20.0, 0.0}};
  EXPECT_EQ(refusal(config), "[obstacles] discs holds a radius that is not positive; wanted r > 0");
}

TEST(WorldConfigCheck, NamesAGivenObstacleOutsideTheArea) {
  WorldConfig config;
  config.obstacles.discs = {{10.0, -0.1, 1.0}};
  EXPECT_EQ(refusal(config),
            "[obstacles] discs holds a centre outside the area; wanted all inside");
}

TEST(WorldConfigCheck, NamesAWallThatLeavesTheArea) {
  WorldConfig config;
  config.area.walls = {{10.0, 10.0, 20.0, 10.0}, {10.0, 10.0, 201.0, 10.0}};
  EXPECT_EQ(refusal(config), "[area] walls holds a point outside the area; wanted all inside");
}

// Holds every default against its own range and remembers the names.
class DefaultsInRange final : public ParameterVisitor {
 public:
  void section(std::string_view name, std::string_view doc) override {
    section_ = name;
    EXPECT_TRUE(doc.ends_with('.')) << name;
  }
  void number(std::string_view key, double& value, Range range, ParameterDoc doc) override {
    known(key, doc);
    EXPECT_GE(value, range.min) << key;
    EXPECT_LE(value, range.max) << key;
    EXPECT_TRUE(std::isfinite(range.min) && std::isfinite(range.max)) << key;
  }
  void integer(std::string_view key, std::int64_t& value, Range range, ParameterDoc doc) override {
    auto as_number = static_cast<double>(value);
    number(key, as_number, range, doc);
  }
  void flag(std::string_view key, bool& /*value*/, ParameterDoc doc) override { known(key, doc); }
  void choice(std::string_view key, std::string& value, std::span<const std::string_view> choices,
              ParameterDoc doc) override {
    known(key, doc);
    EXPECT_NE(std::find(choices.begin(), choices.end(), value), choices.end()) << key;
  }
  void rows(std::string_view key, std::vector<std::vector<double>>& /*value*/,
            std::span<const std::string_view> columns, Range /*range*/, ParameterDoc doc) override {
    known(key, doc);
    EXPECT_FALSE(columns.empty()) << key;
  }
  void text(std::string_view key, std::string& /*value*/, ParameterDoc doc) override {
    known(key, doc);
  }
  void texts(std::string_view key, std::vector<std::string>& /*value*/, ParameterDoc doc) override {
    known(key, doc);
  }
  [[nodiscard]] std::size_t count() const { return names_.size(); }

 private:
  void known(std::string_view key, ParameterDoc doc) {
    EXPECT_TRUE(names_.insert(section_ + "." + std::string(key)).second) << key;
    EXPECT_TRUE(doc.doc.ends_with(']')) << key << ": its source is missing";
  }

  std::string section_;
  std::set<std::string> names_;
};

TEST(WorldParameters, AreInRangeByDefaultNamedOnceAndSourced) {
  for (const MissionKind mission :
       {MissionKind::Guard, MissionKind::Forage, MissionKind::Operation}) {
    WorldConfig config = world_defaults(mission);
    DefaultsInRange visitor;
    describe(config, visitor);
    EXPECT_GT(visitor.count(), 40u) << name(mission);
  }
}

// Writes into everything it is shown.
class Scrambler final : public ParameterVisitor {
 public:
  void section(std::string_view /*name*/, std::string_view /*doc*/) override {}
  void number(std::string_view /*key*/, double& value, Range /*range*/,
              ParameterDoc /*doc*/) override {
    value = ++next_;
  }
  void integer(std::string_view /*key*/, std::int64_t& value, Range /*range*/,
               ParameterDoc /*doc*/) override {
    value = static_cast<std::int64_t>(++next_);
  }
  void flag(std::string_view /*key*/, bool& value, ParameterDoc /*doc*/) override {
    value = !value;
  }
  void choice(std::string_view /*key*/, std::string& value,
              std::span<const std::string_view> /*choices*/, ParameterDoc /*doc*/) override {
    value = "other";
  }
  void rows(std::string_view /*key*/, std::vector<std::vector<double>>& value,
            std::span<const std::string_view> /*columns*/, Range /*range*/,
            ParameterDoc /*doc*/) override {
    value = {{++next_}};
  }
  void text(std::string_view /*key*/, std::string& value, ParameterDoc /*doc*/) override {
    value = "other";
  }
  void texts(std::string_view /*key*/, std::vector<std::string>& value,
             ParameterDoc /*doc*/) override {
    value = {"other"};
  }

 private:
  double next_ = 1000.0;
};

// Binding every member keeps these lists complete: a new member does not compile.
auto members(const AreaConfig& c) {
  const auto& [m1, m2, m3, m4, m5, m6] = c;
  return std::tie(m1, m2, m3, m4, m5, m6);
}
auto members(const TargetConfig& c) {
  const auto& [m1, m2, m3] = c;
  return std::tie(m1, m2, m3);
}
auto members(const ObstacleConfig& c) {
  const auto& [m1, m2, m3, m4, m5, m6] = c;
  return std::tie(m1, m2, m3, m4, m5, m6);
}
auto members(const RobotConfig& c) {
  const auto& [m1, m2, m3, m4, m5, m6, m7] = c;
  return std::tie(m1, m2, m3, m4, m5, m6, m7);
}
auto members(const SightConfig& c) {
  const auto& [m1, m2, m3, m4, m5, m6, m7] = c;
  return std::tie(m1, m2, m3, m4, m5, m6, m7);
}
auto members(const EnemyConfig& c) {
  const auto& [m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16] = c;
  return std::tie(m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16);
}
auto members(const PhysicsConfig& c) {
  const auto& [m1, m2, m3] = c;
  return std::tie(m1, m2, m3);
}
auto members(const OperationScript& c) {
  const auto& [m1, m2, m3, m4, m5, m6] = c;
  return std::tie(m1, m2, m3, m4, m5, m6);
}
auto members(const SignalConfig& c) {
  const auto& [m1, m2, m3] = c;
  return std::tie(m1, m2, m3);
}
auto members(const OperationReachConfig& c) {
  const auto& [m1, m2, m3, m4, m5] = c;
  return std::tie(m1, m2, m3, m4, m5);
}

template <class Section>
void expect_all_changed(const Section& now, const Section& before) {
  std::apply(
      [&before](const auto&... values) {
        std::apply([&](const auto&... olds) { EXPECT_TRUE(((values != olds) && ...)); },
                   members(before));
      },
      members(now));
}

TEST(WorldParameters, CoverEveryMember) {
  const WorldConfig plain;
  WorldConfig config;
  Scrambler visitor;
  describe(config, visitor);
  expect_all_changed(config.area, plain.area);
  expect_all_changed(config.target, plain.target);
  expect_all_changed(config.obstacles, plain.obstacles);
  expect_all_changed(config.robots, plain.robots);
  expect_all_changed(config.sight, plain.sight);
  expect_all_changed(config.enemies, plain.enemies);
  expect_all_changed(config.physics, plain.physics);
}

TEST(WorldParameters, OfAnOperationCoverEveryMember) {
  const WorldConfig plain = world_defaults(MissionKind::Operation);
  WorldConfig config = plain;
  Scrambler visitor;
  describe(config, visitor);
  expect_all_changed(config.operation.script, plain.operation.script);
  expect_all_changed(config.operation.signal, plain.operation.signal);
  expect_all_changed(config.operation.reach, plain.operation.reach);
  EXPECT_NE(config.operation.doorway_range_m, plain.operation.doorway_range_m);
  EXPECT_NE(config.operation.point_reach_m, plain.operation.point_reach_m);
  EXPECT_NE(config.operation.exposure_range_m, plain.operation.exposure_range_m);
  EXPECT_NE(config.operation.proceed, plain.operation.proceed);
}

}  // namespace
}  // namespace tacit
