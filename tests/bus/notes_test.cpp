#include "robot_agent/app/notes.h"

#include "tests/bus/scratch.h"

namespace tacit {
namespace {

class NotesOfABrain : public test::ScratchTest {
 protected:
  [[nodiscard]] std::optional<std::string> learned() const {
    return MemoryFile(folder_ / "learned").load();
  }

  Notes notes_{folder_ / "memory", folder_ / "learned"};
  Notes::Time now_ = std::chrono::steady_clock::now();
};

TEST_F(NotesOfABrain, KeepItsMemoryAndItsPolicy) {
  notes_.save({1, "stand", "table"}, now_);
  EXPECT_EQ(notes_.load(), "stand");
  EXPECT_EQ(learned(), "table");
}

TEST_F(NotesOfABrain, FollowItsDecisions) {
  notes_.save({1, "first", "first table"}, now_);
  notes_.save({2, "second", "second table"}, now_);
  EXPECT_EQ(notes_.load(), "second");
  EXPECT_EQ(learned(), "second table");
}

// One thread takes a note and is held up while another takes the next one and keeps it.
TEST_F(NotesOfABrain, AreNotReplacedByAnOlderOneThatComesLate) {
  notes_.save({8, "with the lesson", "new table"}, now_);
  notes_.save({7, "before the lesson", "old table"}, now_);
  EXPECT_EQ(notes_.load(), "with the lesson");
  EXPECT_EQ(learned(), "new table");
}

TEST_F(NotesOfABrain, AreDueAsOftenAsTheMemory) {
  notes_.save({1, "stand", "table"}, now_);
  EXPECT_FALSE(notes_.due(now_ + MemoryFile::kPeriod / 2));
  EXPECT_TRUE(notes_.due(now_ + MemoryFile::kPeriod));
}

TEST_F(NotesOfABrain, AreNotWantedWithoutAFile) {
  EXPECT_FALSE(Notes({}, {}).wanted());
  EXPECT_TRUE(Notes(folder_ / "memory", {}).wanted());
  EXPECT_TRUE(Notes({}, folder_ / "learned").wanted());
}

TEST_F(NotesOfABrain, TellWhatItWouldRememberAfterThatDecision) {
  const Brain brain(brain_defaults(MissionKind::Forage), RobotId{2}, 5);
  const Note note = note_of(brain, 3);
  EXPECT_EQ(note.decisions, 3U);
  EXPECT_EQ(note.memory, brain.memory());
  EXPECT_EQ(note.policy, brain.policy());
}

}  // namespace
}  // namespace tacit
