#include "console/tape/tape.h"

#include <gtest/gtest.h>

#include "console/tape/tape_reader.h"
#include "idl/bus/cdr.h"
#include "tests/mcap/recording.h"
#include "tests/wire/words.h"

namespace tacit {
namespace {

constexpr const char* kScenario = R"([physics]
tick_s = 0.05
[area]
width_m = 40.0
height_m = 30.0
border_walls = true
walls = [[1.0, 2.0, 3.0, 4.0]]
[operation]
map = "-- a map"
)";

RunFacts facts() {
  RunFacts facts;
  facts.version = "1.2.3";
  facts.scenario = "guard";
  facts.seed = 7;
  return facts;
}

template <class Word>
void put(Tape& tape, const Word& word) {
  std::vector<std::uint8_t> bytes;
  to_cdr(word, bytes);
  tape.add(word, bytes);
}

/// Three batches, of which the second comes twice, as to a reader that comes back.
std::vector<Event> put_events(Tape& tape) {
  const std::vector<Event> events{{1, EnemyCreated{{1}, EnemyKind::Normal, {1.0, 2.0}}},
                                  {2, TargetHit{{1}, 0.5}},
                                  {2, RobotLost{{3}}},
                                  {4, RunEnded{99}}};
  put(tape, EventBatch{0, {events[0]}});
  put(tape, EventBatch{1, {events[1], events[2]}});
  put(tape, EventBatch{1, {events[1], events[2]}});
  put(tape, EventBatch{3, {events[3]}});
  return events;
}

WorldView view_at(Tick tick) {
  WorldView view;
  view.tick = tick;
  view.robots.resize(2);
  view.robots[0].robot = {1};
  view.robots[1].robot = {2};
  view.robots[1].pose.position_m = {3.0, 4.0};
  return view;
}

TEST(Tape, GivesTheEventsBackEachOnce) {
  const test::ScratchFile file;
  Tape tape(file.path(), facts(), kScenario);
  const std::vector<Event> events = put_events(tape);
  tape.finish({});
  std::vector<Event> back;
  TapeReader(file.path()).events([&](const Event& event) { back.push_back(event); });
  EXPECT_EQ(back, events);
}

TEST(Tape, SaysWhichRunItIsOf) {
  const test::ScratchFile file;
  Tape tape(file.path(), facts(), kScenario);
  RunOutcome outcome;
  outcome.event_log_sha256 = "abc";
  tape.finish(outcome);
  const TapeReader reader(file.path());
  EXPECT_EQ(reader.fact("run", "seed"), "7");
  EXPECT_EQ(reader.fact("run", "version"), "1.2.3");
  EXPECT_EQ(reader.fact("outcome", "event_log_sha256"), "abc");
  EXPECT_EQ(reader.fact("outcome", "nothing"), "");
}

TEST(Tape, HoldsScenarioMapAndResult) {
  const test::ScratchFile file;
  Tape tape(file.path(), facts(), kScenario);
  tape.finish({});
  const TapeReader reader(file.path());
  std::map<std::string, std::string> found;
  for (const auto& index : reader.mcap().attachments()) {
    found[index.name] = reader.mcap().attachment(index).data;
  }
  EXPECT_EQ(found["scenario.toml"], kScenario);
  EXPECT_EQ(found["map.ovl"], "-- a map");
  EXPECT_NE(found["metrics.json"].find("\"complete\": false"), std::string::npos);
}

TEST(Tape, CountsTimeAsTheRunDoes) {
  const test::ScratchFile file;
  Tape tape(file.path(), facts(), kScenario);
  put(tape, view_at(20));
  put(tape, view_at(40));
  tape.finish({});
  const TapeReader reader(file.path());
  EXPECT_EQ(reader.mcap().statistics().start_ns, 1'000'000'000U);
  EXPECT_EQ(reader.mcap().statistics().end_ns, 2'000'000'000U);
}

TEST(Tape, GivesTheViewsBack) {
  const test::ScratchFile file;
  Tape tape(file.path(), facts(), kScenario);
  put(tape, view_at(1));
  put(tape, view_at(2));
  tape.finish({});
  std::vector<WorldView> back;
  TapeReader(file.path()).views([&](const WorldView& view) { back.push_back(view); });
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[1].tick, 2U);
  EXPECT_EQ(back[1].robots[1].pose.position_m, WorldVec(3.0, 4.0));
}

TEST(Tape, HasAChannelForEachRobotThatTells) {
  const test::ScratchFile file;
  Tape tape(file.path(), facts(), kScenario);
  test::Words words(3);
  Telemetry telemetry = words.telemetry();
  telemetry.tick = 1;
  telemetry.robot = {2};
  put(tape, telemetry);
  put(tape, telemetry);
  telemetry.robot = {5};
  put(tape, telemetry);
  tape.finish({});
  const McapReader reader(file.path());
  const auto second = reader.channel("/tacit/robot_2/telemetry");
  ASSERT_TRUE(second && reader.channel("/tacit/robot_5/telemetry"));
  EXPECT_EQ(reader.statistics().of_channel.at(*second), 2U);
}

TEST(Tape, ShowsWallsOnceAndBodiesEachTime) {
  const test::ScratchFile file;
  Tape tape(file.path(), facts(), kScenario);
  put(tape, view_at(1));
  put(tape, view_at(2));
  tape.finish({});
  const McapReader reader(file.path());
  EXPECT_EQ(reader.statistics().of_channel.at(*reader.channel("/tacit/walls")), 1U);
  EXPECT_EQ(reader.statistics().of_channel.at(*reader.channel("/tacit/scene")), 2U);
}

TEST(Tape, OfSomethingElseIsRefused) {
  const test::ScratchFile file;
  McapWriter(file.path()).close();
  const TapeReader reader(file.path());
  EXPECT_THROW(reader.events([](const Event&) {}), McapError);
}

TEST(Tape, WhosePlaceIsTakenGetsASpareName) {
  const test::ScratchFile file;
  const std::filesystem::path tape = file.path().string() + ".mcap";
  EXPECT_EQ(spare_name(tape), tape);
  test::write_text(tape, "");
  EXPECT_EQ(spare_name(tape), std::filesystem::path(file.path().string() + ".1.mcap"));
  std::filesystem::remove(tape);
}

}  // namespace
}  // namespace tacit
