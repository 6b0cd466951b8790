#include "console/record/event_reader.h"

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "console/record/record_error.h"
#include "tests/record/events.h"
#include "tests/record/scratch.h"
#include "tests/wire/words.h"

namespace tacit {
namespace {

/// So many that every kind of event is among them.
std::vector<Event> drawn_events() {
  test::Words words(20300131);
  std::vector<Event> all;
  while (all.size() < 4000) {
    const EventBatch batch = words.batch();
    all.insert(all.end(), batch.events.begin(), batch.events.end());
  }
  return all;
}

bool is_event(const std::string& line) { return event_in(line).has_value(); }

TEST(EventIn, GivesEveryKindOfEventBack) {
  std::set<std::size_t> kinds;
  for (const Event& event : drawn_events()) {
    const std::optional<Event> back = event_in(to_line(event));
    ASSERT_EQ(back, event) << to_line(event);
    ASSERT_EQ(to_line(*back), to_line(event));
    kinds.insert(event.what.index());
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Happening>);
}

TEST(EventIn, GivesNumbersBackBitForBit) {
  for (const double number :
       {-0.0, 0.1, 5e-324, 1.0 / 3.0, 1e308, std::numeric_limits<double>::max()}) {
    const std::optional<Event> back =
        event_in(to_line({~Tick{0}, MineDropped{{65535}, {0xffffffff}, {number, -number}}}));
    ASSERT_TRUE(back) << number;
    const WorldVec place = std::get<MineDropped>(back->what).position_m;
    EXPECT_EQ(std::signbit(place.x()), std::signbit(number));
    EXPECT_EQ(place, (WorldVec{number, -number}));
  }
}

TEST(EventIn, GivesWordsBackThatNeedEscapes) {
  const Event event{3, Signalled{{1}, Word(R"(a "b\" \\ {,}: c)"), 2}};
  EXPECT_EQ(event_in(to_line(event)), event);
}

TEST(EventIn, RefusesNumbersThatAreNone) {
  for (const double number : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(is_event(to_line({3, TargetHit{{1}, number}})));
  }
}

TEST(EventIn, TellsEventsFromAllElse) {
  EXPECT_TRUE(is_event(R"({"tick":1,"event":"mine_taken","robot":2,"mine":3})"));
  for (const char* line : {
           "",
           "{}",
           "null",
           R"({"tick":1})",
           R"({"tick":1,"event":"mine_eaten","robot":2,"mine":3})",
           R"({"tick":1,"event":"mine_taken","robot":2})",
           R"({"tick":1,"event":"mine_taken","robot":2,"mine":3)",
           R"({"tick":1,"event":"mine_taken","robot":2,"mine":3}})",
           R"({"tick":1,"event":"mine_taken","robot":2,"mine":3} )",
           R"({"tick":1,"event":"mine_taken","robot":2,"mine":3,"left":4})",
           R"({"tick":1,"event":"mine_taken","mine":3,"robot":2})",
           R"({"event":"mine_taken","tick":1,"robot":2,"mine":3})",
           R"({"tick":-1,"event":"mine_taken","robot":2,"mine":3})",
           R"({"tick":18446744073709551616,"event":"mine_taken","robot":2,"mine":3})",
           R"({"tick":1,"event":"mine_taken","robot":65536,"mine":3})",
           R"({"tick":1,"event":"mine_taken","robot":02,"mine":3})",
           R"({"tick":1,"event":"mine_taken","robot":2.0,"mine":3})",
           R"({"tick":1,"event":"mine_taken","robot":"2","mine":3})",
           R"({"tick":1,"event":"mine_taken","robot":null,"mine":3})",
           R"({"tick":1,"event":"mine_taken", "robot":2,"mine":3})",
           R"({"tick":1,"event":"target_hit","enemy":1,"distance_to_target_m":1.50})",
           R"({"tick":1,"event":"target_hit","enemy":1,"distance_to_target_m":nan})",
           R"({"tick":1,"event":"target_hit","enemy":1,"distance_to_target_m":1e999})",
           R"({"tick":1,"event":"robot_disabled","robot":1,"by":"fright"})",
           R"({"tick":1,"event":"robot_disabled","robot":1,"by":""})",
           R"({"tick":1,"event":"robot_exposed","robot":1,"to":2,"exposed":1})",
           R"({"tick":1,"event":"run_ended","state":"000000000000FEED"})",
           R"({"tick":1,"event":"run_ended","state":"feed"})",
           R"({"tick":1,"event":"run_ended","state":"0000000000000feed"})",
           R"({"tick":1,"event":"alerted","robot":1,"word":"a\n"})",
           R"({"tick":1,"event":"alerted","robot":1,"word":"a\)",
       }) {
    EXPECT_FALSE(is_event(line)) << line;
  }
  EXPECT_FALSE(
      is_event(R"({"tick":1,"event":"alerted","robot":1,"word":")" + std::string(64, 'a') + "\"}"));
  EXPECT_FALSE(is_event("{\"tick\":1,\"event\":\"alerted\",\"robot\":1,\"word\":\"\t\"}"));
}

TEST(EventIn, TakesNoDamagedLineForAnother) {
  Stream chance(7, "damage");
  for (const Event& event : drawn_events()) {
    std::string line = to_line(event);
    line[chance.below(line.size())] = static_cast<char>(chance.below(256));
    const std::optional<Event> back = event_in(line);
    ASSERT_TRUE(!back || to_line(*back) == line) << line;
    ASSERT_FALSE(is_event(line.substr(0, chance.below(line.size()))));
  }
}

class ReadEventsTest : public ScratchTest {
 protected:
  std::vector<Event> read() const {
    std::vector<Event> events;
    read_events(file, [&events](const Event& event) { events.push_back(event); });
    return events;
  }
  std::string complaint_of_reading() const {
    return complaint<RecordError>([this] { (void)read(); });
  }

  const std::filesystem::path file = folder / "events.jsonl";
};

TEST_F(ReadEventsTest, GivesTheEventsOfALog) {
  put(file, lines_of(a_run()));
  EXPECT_EQ(read(), a_run());
}

TEST_F(ReadEventsTest, PassesOverALastLineWithoutItsNewline) {
  const std::string text = lines_of(a_run());
  put(file, text.substr(0, text.size() - 1));
  std::vector<Event> all_but_one = a_run();
  all_but_one.pop_back();
  EXPECT_EQ(read(), all_but_one);
}

TEST_F(ReadEventsTest, NamesFileAndLineOfWhatIsNoEvent) {
  put(file, to_line(a_run()[0]) + "\nnonsense\n" + to_line(a_run()[1]) + "\n");
  const std::string said = complaint_of_reading();
  EXPECT_TRUE(said.starts_with(file.string() + ": line 2: found nonsense")) << said;
}

TEST_F(ReadEventsTest, SaysThatThereIsNoFile) {
  EXPECT_EQ(complaint_of_reading(), file.string() + ": cannot be read, wanted an event log");
}

TEST_F(ReadEventsTest, TakesNoFolderForALog) {
  std::filesystem::create_directories(file);
  EXPECT_EQ(complaint_of_reading(), file.string() + ": cannot be read, wanted an event log");
}

}  // namespace
}  // namespace tacit
