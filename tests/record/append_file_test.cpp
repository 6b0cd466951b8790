#include "console/record/append_file.h"

#include "console/record/record_error.h"
#include "tests/record/full_disk.h"
#include "tests/record/scratch.h"

namespace tacit {
namespace {

using AppendFileTest = ScratchTest;
using WholeFileTest = ScratchTest;

TEST_F(AppendFileTest, KeepsWhatItHolds) {
  put(folder / "f", "one\n");
  AppendFile(folder / "f").append("two\n");

  EXPECT_EQ(text_of(folder / "f"), "one\ntwo\n");
}

TEST_F(AppendFileTest, CutsOffATornLineWhereverItTore) {
  const std::string whole = "first\nsecond\n";
  const std::string last = "a last line\n";
  for (std::size_t kept = 0; kept < last.size(); ++kept) {
    put(folder / "f", whole + last.substr(0, kept));
    EXPECT_EQ(AppendFile(folder / "f").size(), whole.size());
    EXPECT_EQ(text_of(folder / "f"), whole) << kept;
  }
}

TEST_F(AppendFileTest, CutsOffATornLineLongerThanItsReadingBlock) {
  put(folder / "f", "whole\n" + std::string(200'000, 'x'));
  AppendFile(folder / "f").append("next\n");

  EXPECT_EQ(text_of(folder / "f"), "whole\nnext\n");
}

TEST_F(AppendFileTest, CutsAFileOfOneTornLineToNothing) {
  put(folder / "f", "torn");
  EXPECT_EQ(AppendFile(folder / "f").size(), 0);
}

TEST_F(AppendFileTest, StaysAsItWasWhenTheDiskIsFull) {
  AppendFile file(folder / "f");
  file.append("fits\n");
  {
    const FullDisk full(8);
    EXPECT_EQ(complaint<RecordError>([&] { file.append("does not\n"); }),
              (folder / "f").string() + ": cannot be written: File too large");
  }
  EXPECT_EQ(text_of(folder / "f"), "fits\n");
}

TEST_F(AppendFileTest, GoesOnOnceThereIsRoomAgain) {
  AppendFile file(folder / "f");
  {
    const FullDisk full(3);
    EXPECT_THROW(file.append("line\n"), RecordError);
  }
  file.append("line\n");

  EXPECT_EQ(text_of(folder / "f"), "line\n");
}

TEST_F(AppendFileTest, HasOneWriterAtATime) {
  const AppendFile first(folder / "f");

  EXPECT_EQ(complaint<RecordError>([&] { AppendFile second(folder / "f"); }),
            (folder / "f").string() + ": another process is writing to it");
}

TEST_F(AppendFileTest, NamesTheFileThatCannotBeOpened) {
  EXPECT_EQ(complaint<RecordError>([&] { AppendFile file(folder / "none" / "f"); }),
            (folder / "none" / "f").string() + ": No such file or directory");
}

TEST_F(WholeFileTest, IsReplacedAsAWhole) {
  write_whole_file(folder / "f", "old");
  write_whole_file(folder / "f", "new");

  EXPECT_EQ(read_whole_file(folder / "f"), "new");
}

TEST_F(WholeFileTest, KeepsItsOldTextWhenTheDiskIsFull) {
  write_whole_file(folder / "f", "old");
  {
    const FullDisk full(100);
    EXPECT_THROW(write_whole_file(folder / "f", std::string(1000, 'x')), RecordError);
  }
  EXPECT_EQ(text_of(folder / "f"), "old");
}

TEST_F(WholeFileTest, LeavesNothingElseBehind) {
  write_whole_file(folder / "f", "text");
  {
    const FullDisk full(0);
    EXPECT_THROW(write_whole_file(folder / "g", "text"), RecordError);
  }
  const auto files = std::filesystem::directory_iterator(folder);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(WholeFileTest, AnEmptyOneReadsAsAnEmptyText) {
  put(folder / "f", "");
  EXPECT_EQ(read_whole_file(folder / "f"), "");
}

TEST_F(WholeFileTest, AFolderOrNothingIsNoFile) {
  EXPECT_THROW((void)read_whole_file(folder), RecordError);
  EXPECT_THROW((void)read_whole_file(folder / "none"), RecordError);
}

}  // namespace
}  // namespace tacit
