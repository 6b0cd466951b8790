#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mcap/recording.h"

namespace tacit {
namespace {

using test::heard;
using test::Sample;

TEST(Mcap, GivesBackWhatWasWritten) {
  Sample sample;
  sample.writer().close();
  const McapReader reader(sample.path());
  EXPECT_EQ(reader.trouble(), "");
  EXPECT_TRUE(reader.data_checksum_holds());
  EXPECT_EQ(heard(reader), sample.said());
  EXPECT_EQ(reader.schemas().at(1).text, "uint8 x\n");
  EXPECT_EQ(reader.channels().at(sample.one()).topic, "/one");
  EXPECT_EQ(reader.channels().at(sample.one()).schema, 1);
  EXPECT_EQ(reader.channel("/two"), sample.two());
  EXPECT_EQ(reader.channel("/three"), std::nullopt);
}

TEST(Mcap, CountsWhatWasWritten) {
  Sample sample;
  sample.writer().close();
  const mcap::Statistics counted = McapReader(sample.path()).statistics();
  EXPECT_EQ(counted.messages, 200U);
  EXPECT_EQ(counted.of_channel.at(sample.two()), 67U);
  EXPECT_EQ(counted.start_ns, 0U);
  EXPECT_EQ(counted.end_ns, 199'000U);
  EXPECT_GT(counted.chunks, 10U);
  EXPECT_EQ(counted.schemas, 1);
  EXPECT_EQ(counted.channels, 2U);
}

TEST(Mcap, KeepsAttachmentsAndMetadata) {
  Sample sample;
  sample.writer().close();
  const McapReader reader(sample.path());
  ASSERT_EQ(reader.attachments().size(), 1U);
  EXPECT_EQ(reader.attachment(reader.attachments()[0]).data, "[run]\nseed = 7\n");
  ASSERT_EQ(reader.metadata().size(), 1U);
  EXPECT_EQ(reader.metadata()[0].values.at("seed"), "7");
}

TEST(Mcap, SeeksByTime) {
  Sample sample;
  sample.writer().close();
  const auto stretch = heard(McapReader(sample.path()), {50'000, 60'000});
  const std::vector<test::Heard> wanted(sample.said().begin() + 50, sample.said().begin() + 61);
  EXPECT_EQ(stretch, wanted);
}

TEST(Mcap, PutsMessagesOfOverlappingChunksInOrder) {
  Sample sample;
  for (std::uint64_t i = 0; i < 100; ++i) sample.say(sample.one(), 150'000 + 700 * (99 - i));
  sample.writer().close();
  std::vector<test::Heard> wanted = sample.said();
  std::stable_sort(wanted.begin(), wanted.end(),
                   [](const auto& a, const auto& b) { return a.time_ns < b.time_ns; });
  EXPECT_EQ(heard(McapReader(sample.path())), wanted);
}

TEST(Mcap, WithoutMessagesIsWhole) {
  const test::ScratchFile file;
  McapWriter(file.path()).close();
  const McapReader reader(file.path());
  EXPECT_EQ(reader.trouble(), "");
  EXPECT_EQ(reader.statistics().messages, 0U);
  EXPECT_TRUE(heard(reader).empty());
}

TEST(Mcap, IsNotWrittenOverAFileThatIsThere) {
  const test::ScratchFile file;
  test::write_text(file.path(), "somebody's");
  EXPECT_THROW(McapWriter(file.path()), McapError);
  EXPECT_EQ(test::text_of(file.path()), "somebody's");
}

TEST(Mcap, IsFlushedWhenItsChunkIsOld) {
  const test::ScratchFile file;
  McapWriter::Setting setting;
  setting.chunk_age = std::chrono::milliseconds(0);
  McapWriter writer(file.path(), setting);
  writer.write(writer.add_channel(0, "/one", "json"), 1, test::span_of("{}"));
  writer.flush_if_due();
  EXPECT_EQ(heard(McapReader(file.path())).size(), 1U);
}

}  // namespace
}  // namespace tacit
