#include "console/record/event_log.h"

#include <sys/wait.h>

#include <csignal>

#include "console/record/record_error.h"
#include "tests/record/events.h"
#include "tests/record/full_disk.h"
#include "tests/record/scratch.h"

namespace tacit {
namespace {

class EventLogTest : public ScratchTest {
 protected:
  const std::filesystem::path file = folder / "events.jsonl";
  const std::vector<Event> events = a_run();
  const std::string text = lines_of(events);
};

TEST_F(EventLogTest, HoldsALinePerEvent) {
  EventLog log(file);
  log.append(events);

  EXPECT_EQ(text_of(file), text);
  EXPECT_EQ(log.events(), events.size());
}

TEST_F(EventLogTest, IsTheSameInWhateverPortionsTheEventsCome) {
  EventLog log(file);
  const std::span all(events);
  log.append(all.first(1));
  log.append(all.subspan(1, 0));
  log.append(all.subspan(1, 4));
  log.append(all.subspan(5));

  EXPECT_EQ(text_of(file), text);
  EXPECT_EQ(log.sha256(), sha256_of_text(text));
}

TEST_F(EventLogTest, ItsHashIsThatOfItsFile) {
  EventLog log(file);
  log.append(events);

  EXPECT_EQ(log.sha256(), sha256_of_file(file));
}

TEST_F(EventLogTest, AHashWithoutALogIsTheSame) {
  EventHash hash;
  hash.add(events);

  EXPECT_EQ(hash.hex(), sha256_of_text(text));
}

TEST_F(EventLogTest, CutAtAnyByteItIsMadeWholeByTheSameEvents) {
  for (std::size_t kept = 0; kept <= text.size(); ++kept) {
    put(file, text.substr(0, kept));
    EventLog log(file);
    for (const Event& event : events) {
      log.append({&event, 1});
    }
    ASSERT_EQ(text_of(file), text) << kept;
    ASSERT_EQ(log.sha256(), sha256_of_text(text)) << kept;
    ASSERT_FALSE(log.expects_more()) << kept;
  }
}

TEST_F(EventLogTest, KnowsThatEventsItHoldsHaveNotComeAgain) {
  put(file, text);
  EventLog log(file);
  log.append(std::span(events).first(3));

  EXPECT_TRUE(log.expects_more());
  EXPECT_EQ(log.events(), 3);
  EXPECT_EQ(log.sha256(), sha256_of_text(text)) << "of the file, not of the events so far";
}

TEST_F(EventLogTest, RefusesAnotherRunThanTheOneItHolds) {
  put(file, text);
  EventLog log(file);
  std::vector<Event> others = events;
  others[2] = {7, RobotLost{RobotId{2}}};

  EXPECT_EQ(complaint<RecordError>([&] { log.append(others); }),
            file.string() + ": event 2 is " + to_line(events[2]) + ", but the run now has " +
                to_line(others[2]));
  EXPECT_EQ(text_of(file), text);
}

TEST_F(EventLogTest, HoldsWholeLinesAndTheirHashWhenTheDiskIsFull) {
  EventLog log(file);
  const std::span all(events);
  log.append(all.first(3));
  const std::string before = text_of(file);
  {
    const FullDisk full(before.size() + 20);
    EXPECT_THROW(log.append(all.subspan(3)), RecordError);
  }
  EXPECT_EQ(text_of(file), before);
  EXPECT_EQ(log.sha256(), sha256_of_text(before));
  EXPECT_EQ(log.events(), 3);
}

TEST_F(EventLogTest, KeepsWhatItTookWhenItsProcessIsKilled) {
  const pid_t child = ::fork();
  if (child == 0) {
    EventLog log(file);
    log.append(events);
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);

  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(text_of(file), text);
}

TEST_F(EventLogTest, ADeviceThatIsAlwaysFullIsNamed) {
  std::filesystem::create_symlink("/dev/full", file);
  const auto act = [&] { EventLog(file).append(events); };

  EXPECT_EQ(complaint<RecordError>(act),
            file.string() + ": cannot be written: No space left on device");
}

}  // namespace
}  // namespace tacit
