#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "idl/types/event.h"
#include "idl/types/random.h"

namespace tacit {
namespace {

std::string line(const Happening& what) { return to_line({1200, what}); }

TEST(EventLine, OfACreationNamesEnemyKindAndPlace) {
  EXPECT_EQ(
      line(EnemyCreated{{7}, EnemyKind::Decoy, {0.4, 200.0}}),
      R"({"tick":1200,"event":"enemy_created","enemy":7,"kind":"decoy","x_m":0.4,"y_m":200})");
}

TEST(EventLine, OfAnInterceptionNamesEnemyKindRobotAndDistance) {
  EXPECT_EQ(line(EnemyIntercepted{{7}, EnemyKind::Normal, {3}, 12.5}),
            R"({"tick":1200,"event":"enemy_intercepted","enemy":7,"kind":"normal","robot":3,)"
            R"("distance_to_target_m":12.5})");
}

TEST(EventLine, OfAHitNamesEnemyAndDistance) {
  EXPECT_EQ(line(TargetHit{{7}, 1.75}),
            R"({"tick":1200,"event":"target_hit","enemy":7,"distance_to_target_m":1.75})");
}

TEST(EventLine, OfACollisionNamesRobotAndWhatItTouched) {
  EXPECT_EQ(line(Collision{{3}, Obstruction::Wall, 2}),
            R"({"tick":1200,"event":"collision","robot":3,"with":"wall","other":2})");
}

TEST(EventLine, OfALossAReturnAndALateCommandNamesTheRobot) {
  EXPECT_EQ(line(RobotLost{{3}}), R"({"tick":1200,"event":"robot_lost","robot":3})");
  EXPECT_EQ(line(RobotBack{{3}}), R"({"tick":1200,"event":"robot_back","robot":3})");
  EXPECT_EQ(line(RobotLate{{3}}), R"({"tick":1200,"event":"robot_late","robot":3})");
}

TEST(EventLine, OfACheckpointHoldsTheDigestAndTheMeans) {
  EXPECT_EQ(line(Checkpoint{0x0123456789abcdef, 4, 10.25, 0.5}),
            R"({"tick":1200,"event":"checkpoint","state":"0123456789abcdef","enemies":4,)"
            R"("mean_distance_to_target_m":10.25,"mean_speed_mps":0.5})");
}

TEST(EventLine, OfTheEndHoldsTheDigestWithItsLeadingZeros) {
  EXPECT_EQ(line(RunEnded{0xff}),
            R"({"tick":1200,"event":"run_ended","state":"00000000000000ff"})");
}

TEST(EventLine, OfAMineNamesRobotAndMine) {
  EXPECT_EQ(line(MineTaken{{3}, {9}}), R"({"tick":1200,"event":"mine_taken","robot":3,"mine":9})");
  EXPECT_EQ(line(MineDropped{{3}, {9}, {1.5, 2.0}}),
            R"({"tick":1200,"event":"mine_dropped","robot":3,"mine":9,"x_m":1.5,"y_m":2})");
  EXPECT_EQ(line(MineStored{{3}, {9}, 4}),
            R"({"tick":1200,"event":"mine_stored","robot":3,"mine":9,"left":4})");
}

TEST(EventLine, OfAMishapAndItsRemedyNamesTheRobots) {
  EXPECT_EQ(line(RobotDisabled{{3}, Mishap::Mud}),
            R"({"tick":1200,"event":"robot_disabled","robot":3,"by":"mud"})");
  EXPECT_EQ(line(RobotRevived{{3}, {5}}),
            R"({"tick":1200,"event":"robot_revived","robot":3,"by":5})");
  EXPECT_EQ(line(EnemyRetreated{{7}}), R"({"tick":1200,"event":"enemy_retreated","enemy":7})");
}

TEST(EventLine, OfAForageRunsBeginningHoldsTheNumberOfMines) {
  EXPECT_EQ(line(ForageBegun{20}), R"({"tick":1200,"event":"forage_begun","mines":20})");
}

TEST(EventLine, OfAMissionsEndHoldsVerdictAndScore) {
  EXPECT_EQ(line(MissionOver{Verdict::TeamLost, 1000000}),
            R"({"tick":1200,"event":"mission_over","verdict":"team_lost","score_ticks":1000000})");
}

std::vector<Happening> extremes() {
  constexpr auto kRobot = RobotId{std::numeric_limits<std::uint16_t>::max()};
  constexpr auto kEnemy = EnemyId{std::numeric_limits<std::uint32_t>::max()};
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  constexpr double kHuge = std::numeric_limits<double>::max();
  return {EnemyCreated{kEnemy, EnemyKind::Normal, {-kHuge, kTiny}},
          EnemyIntercepted{kEnemy, EnemyKind::Decoy, kRobot, kHuge},
          TargetHit{kEnemy, kTiny},
          Collision{kRobot, Obstruction::Enemy, std::numeric_limits<std::uint32_t>::max()},
          RobotLost{kRobot},
          RobotBack{kRobot},
          RobotLate{kRobot},
          Checkpoint{~std::uint64_t{0}, 0xffffffff, kHuge, -kTiny},
          RunEnded{~std::uint64_t{0}},
          EnemyRetreated{kEnemy},
          MineTaken{kRobot, {kEnemy.value}},
          MineDropped{kRobot, {kEnemy.value}, {kHuge, -kTiny}},
          MineStored{kRobot, {kEnemy.value}, 0xffffffff},
          RobotDisabled{kRobot, Mishap::Enemy},
          RobotRevived{kRobot, kRobot},
          MissionOver{Verdict::OutOfTime, std::numeric_limits<Tick>::max()},
          ForageBegun{0xffffffff},
          OperationBegun{0xffffffff, 0xffffffff},
          ObjectTaken{kRobot, {kEnemy.value}},
          ObjectDropped{kRobot, {kEnemy.value}, {kHuge, -kTiny}},
          ObjectStored{kRobot, {kEnemy.value}, {1}},
          ObjectTested{kRobot, {kEnemy.value}, Finding::Dangerous},
          DoorwayMarked{kRobot, 0xffffffff, false},
          SiteEntered{kRobot, Site::Hallway, 0xffffffff},
          PointReached{kRobot, 0xffffffff},
          Signalled{kRobot, Word("\"\\ ~"), 0xffffffff},
          Alerted{kRobot, Word(std::string(Word::kMaxLength, '"'))},
          RobotExposed{kRobot, kRobot, false},
          RobotFinished{kRobot},
          OperatorActed{kRobot, OperatorAct::Steer, {kTiny, -1.0}}};
}

TEST(EventLine, IsOneLineOfJsonForEveryKindOfEvent) {
  const std::vector<Happening> all = extremes();
  ASSERT_EQ(all.size(), std::variant_size_v<Happening>);
  for (const Happening& what : all) {
    const std::string text = to_line({std::numeric_limits<Tick>::max(), what});
    ASSERT_TRUE(nlohmann::json::accept(text)) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(text).at("tick"), std::numeric_limits<Tick>::max());
  }
}

TEST(EventLine, IsDifferentForEveryKindOfEvent) {
  std::vector<std::string> names;
  for (const Happening& what : extremes()) {
    names.push_back(nlohmann::json::parse(line(what)).at("event"));
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

// How the number stands in the log.
std::string printed(double value) {
  const std::string text = line(TargetHit{{1}, value});
  const std::size_t colon = text.rfind(':');
  return text.substr(colon + 1, text.size() - colon - 2);
}

std::size_t digits(const std::string& number) {
  const std::string mantissa = number.substr(0, number.find('e'));
  std::string only;
  std::copy_if(mantissa.begin(), mantissa.end(), std::back_inserter(only),
               [](char c) { return c >= '0' && c <= '9'; });
  only.erase(0, only.find_first_not_of('0'));
  return only.find_last_not_of('0') + 1;
}

TEST(EventLine, PrintsNumbersThatReadBackToTheSameBits) {
  Stream chance(1, "numbers");
  for (int i = 0; i < 5000; ++i) {
    const double value =
        std::ldexp(chance.uniform(-1.0, 1.0), static_cast<int>(chance.below(2000)) - 1000);
    ASSERT_EQ(std::stod(printed(value)), value) << printed(value);
  }
}

TEST(EventLine, PrintsNoDigitMoreThanReadingBackNeeds) {
  Stream chance(2, "numbers");
  for (int i = 0; i < 2000; ++i) {
    const double value = chance.uniform(-300.0, 300.0);
    const auto shorter = static_cast<int>(digits(printed(value))) - 1;
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*g", std::max(shorter, 1), value);
    ASSERT_NE(std::stod(text.data()), value) << printed(value);
  }
}

TEST(EventLine, PrintsWholeNumbersWithoutAPoint) {
  EXPECT_EQ(printed(200.0), "200");
  EXPECT_EQ(printed(0.1), "0.1");
}

}  // namespace
}  // namespace tacit
