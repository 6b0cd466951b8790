#include <gtest/gtest.h>

#include <algorithm>

#include "tests/world/operation_field.h"

namespace tacit {
namespace {

const std::string kThings =
    "OBJECT 4 5 0.3 Movable brown\nOBJECT 7 5 0.3 Fixed brown\nOBJECT 9 5 0.3 Container green\n"
    "OBJECT 6 8 0.3 Movable orange\n";

WorldConfig busy_floor() {
  WorldConfig config = with_extras(
      on_floor({{2.0, 5.0, 0.0}, {5.0, 5.0, 90.0}, {6.0, 8.0, 0.0}, {12.0, 5.0, 180.0}}, kThings),
      1);
  config.operation.signal.missed_share = 0.5;
  return config;
}

/// Whatever robots of an operation can want but an end.
std::vector<Command> random_wishes(std::int64_t robots, Stream& chance) {
  static constexpr std::array<Act, 8> kActs{Act::None, Act::PickUp, Act::Drop,   Act::Test,
                                            Act::Mark, Act::Unmark, Act::Signal, Act::Alert};
  std::vector<Command> commands;
  for (std::uint16_t i = 1; i <= robots; ++i) {
    Command command = acting(i, kActs.at(chance.below(kActs.size())),
                             {chance.uniform(-0.5, 1.0), chance.uniform(-0.5, 0.5)});
    command.turn_radps = chance.uniform(-1.0, 1.0);
    command.word = Word("word " + std::to_string(chance.below(5)));
    commands.push_back(command);
  }
  return commands;
}

/// All events of 300 ticks and the state at their end; commands come reversed if `reversed`.
std::string history(bool reversed) {
  World world(busy_floor(), 7);
  Stream chance(3, "wishes");
  std::string lines;
  for (int i = 0; i < 300; ++i) {
    std::vector<Command> commands = random_wishes(4, chance);
    if (reversed) {
      std::reverse(commands.begin(), commands.end());
    }
    world.operate({ControlKind::Steer, 1, 0.0, RobotId{1}, {chance.uniform(), 0.0}});
    for (const Event& event : world.step(commands)) {
      lines += to_line(event) + '\n';
    }
  }
  return lines + std::to_string(world.digest());
}

TEST(OperationLaws, TheSameCommandsMakeTheSameHistoryInWhateverOrderTheyCome) {
  const std::string once = history(false);
  EXPECT_EQ(once, history(false));
  EXPECT_EQ(once, history(true));
  for (const char* kind : {"object_taken", "object_tested", "doorway_marked", "signalled",
                           "alerted", "site_entered", "operator_acted", "robot_exposed"}) {
    EXPECT_NE(once.find(kind), std::string::npos) << kind;
  }
}

/// Whether `act` changes what two worlds' digests tell apart, with all robots where they were.
bool shows(const Command& command) {
  World still(busy_floor(), 1);
  World acting_world(busy_floor(), 1);
  still.step({});
  acting_world.step({&command, 1});
  return still.digest() != acting_world.digest();
}

TEST(OperationLaws, TheDigestShowsWhatActsLeaveBehind) {
  EXPECT_FALSE(shows(acting(2, Act::None)));
  EXPECT_TRUE(shows(acting(2, Act::PickUp)));
  EXPECT_TRUE(shows(acting(2, Act::Test)));
  EXPECT_TRUE(shows(acting(2, Act::Mark)));
  EXPECT_TRUE(shows(acting(2, Act::Finish)));
}

TEST(OperationLaws, OneRobotMoreThatDoesNothingLeavesTheOthersAsTheyWere) {
  WorldConfig more = on_floor({{2.0, 5.0, 0.0}, {18.0, 10.0, 0.0}}, kThings);
  World alone(on_floor({{2.0, 5.0, 0.0}}, kThings), 1);
  World beside(more, 1);
  Stream chance(5, "wishes");
  for (int i = 0; i < 200; ++i) {
    const std::vector<Command> commands = random_wishes(1, chance);
    alone.step(commands);
    beside.step(commands);
    ASSERT_EQ(alone.percepts()[0].odometry.position_m, beside.percepts()[0].odometry.position_m);
    ASSERT_EQ(alone.percepts()[0].deeds, beside.percepts()[0].deeds);
  }
}

}  // namespace
}  // namespace tacit
