#include "robot_agent/app/memory_file.h"

#include "tests/bus/scratch.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

class MemoryFiles : public test::ScratchTest {
 protected:
  [[nodiscard]] fs::path path() const { return folder_ / "memory"; }

  MemoryFile::Time now_ = std::chrono::steady_clock::now();
};

TEST_F(MemoryFiles, GiveBackWhatWasSaved) {
  MemoryFile file(path());
  file.save("learned", now_);
  EXPECT_EQ(MemoryFile(path()).load(), "learned");
}

TEST_F(MemoryFiles, HoldNothingAtFirst) { EXPECT_EQ(MemoryFile(path()).load(), std::nullopt); }

TEST_F(MemoryFiles, KeepTheNewest) {
  MemoryFile file(path());
  file.save("a longer one", now_);
  file.save("short", now_);
  EXPECT_EQ(file.load(), "short");
}

TEST_F(MemoryFiles, LeaveNothingElseBehind) {
  MemoryFile(path()).save("learned", now_);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(MemoryFiles, AreDueEveryHalfSecond) {
  MemoryFile file(path());
  EXPECT_TRUE(file.due(now_));
  file.save("learned", now_);
  EXPECT_FALSE(file.due(now_ + std::chrono::milliseconds(499)));
  EXPECT_TRUE(file.due(now_ + std::chrono::milliseconds(500)));
}

TEST_F(MemoryFiles, WithoutAPathKeepNothing) {
  MemoryFile file{fs::path()};
  EXPECT_FALSE(file.due(now_));
  EXPECT_EQ(file.load(), std::nullopt);
}

TEST_F(MemoryFiles, ThatCannotBeWrittenDoNotEndTheRun) {
  MemoryFile file(folder_ / "no" / "such" / "folder");
  EXPECT_NO_THROW(file.save("learned", now_));
}

}  // namespace
}  // namespace tacit
