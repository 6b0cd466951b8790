#include <gtest/gtest.h>

#include "tests/mcap/recording.h"

namespace tacit {
namespace {

using test::heard;
using test::Sample;
using test::ScratchFile;
using test::write_text;

bool is_prefix(const std::vector<test::Heard>& part, const std::vector<test::Heard>& whole) {
  return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

TEST(DamagedMcap, CutOffAnywhereGivesAPrefix) {
  Sample sample;
  sample.writer().close();
  const std::string whole = test::text_of(sample.path());
  const ScratchFile file;
  std::size_t least = 0;
  for (std::size_t size = 8; size < whole.size(); size += 100) {
    write_text(file.path(), whole.substr(0, size));
    const McapReader reader(file.path());
    EXPECT_NE(reader.trouble(), "") << size;
    const auto got = heard(reader);
    ASSERT_TRUE(is_prefix(got, sample.said())) << size;
    EXPECT_GE(got.size(), least) << size;
    EXPECT_EQ(got.size(), reader.statistics().messages);
    least = got.size();
  }
  EXPECT_EQ(least, 200U);
}

TEST(DamagedMcap, OfAWriterThatDiedHoldsWhatItFlushed) {
  Sample sample;
  sample.writer().flush();
  const McapReader reader(sample.path());
  EXPECT_EQ(heard(reader), sample.said());
  EXPECT_EQ(reader.attachments().size(), 1U);
  EXPECT_EQ(reader.metadata().size(), 1U);
  EXPECT_NE(reader.trouble().find("no end"), std::string::npos) << reader.trouble();
}

/// The whole sample with a byte turned over.
std::string with_flaw(const Sample& sample, std::size_t at) {
  std::string text = test::text_of(sample.path());
  text[at] = static_cast<char>(text[at] ^ 0x55);
  return text;
}

TEST(DamagedMcap, IsToldByTheChecksumOfAChunk) {
  Sample sample;
  sample.writer().close();
  const ScratchFile file;
  write_text(file.path(), with_flaw(sample, test::text_of(sample.path()).find("zstd") + 60));
  const McapReader reader(file.path());
  EXPECT_THROW((void)heard(reader), McapError);
  EXPECT_FALSE(reader.data_checksum_holds());
}

TEST(DamagedMcap, IsToldByTheChecksumOfItsSummaryAndReadAllTheSame) {
  Sample sample;
  sample.writer().close();
  const ScratchFile file;
  write_text(file.path(), with_flaw(sample, test::text_of(sample.path()).size() - 60));
  const McapReader reader(file.path());
  EXPECT_NE(reader.trouble().find("checksum of its summary"), std::string::npos);
  EXPECT_EQ(heard(reader), sample.said());
}

TEST(DamagedMcap, IsToldByTheChecksumOfAnAttachment) {
  Sample sample;
  sample.writer().close();
  const ScratchFile file;
  write_text(file.path(), with_flaw(sample, test::text_of(sample.path()).find("seed = 7")));
  const McapReader reader(file.path());
  EXPECT_THROW((void)reader.attachment(reader.attachments().at(0)), McapError);
}

TEST(DamagedMcap, NeverDoesHarm) {
  Sample sample;
  sample.writer().close();
  const std::string whole = test::text_of(sample.path());
  const ScratchFile file;
  std::size_t refused = 0;
  for (std::size_t at = 8; at < whole.size(); at += 7) {
    write_text(file.path(), with_flaw(sample, at));
    try {
      const McapReader reader(file.path());
      (void)reader.metadata();
      for (const auto& each : reader.attachments()) (void)reader.attachment(each);
      (void)heard(reader);
      (void)reader.data_checksum_holds();
    } catch (const McapError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0U);
}

/// A record that claims to be longer than memory.
TEST(DamagedMcap, WithAHugeLengthIsReadUpToIt) {
  Sample sample;
  sample.writer().flush();
  std::string text = test::text_of(sample.path());
  text += '\x06';
  text += std::string(8, '\x7f') + "rest";
  const ScratchFile file;
  write_text(file.path(), text);
  EXPECT_EQ(heard(McapReader(file.path())), sample.said());
}

TEST(DamagedMcap, ThatIsNoneIsSaidToBeNone) {
  const ScratchFile file;
  for (const std::string text : {"", "\x89MCAP", "PK\x03\x04 something else altogether"}) {
    write_text(file.path(), text);
    try {
      const McapReader reader(file.path());
      ADD_FAILURE() << text;
    } catch (const McapError& error) {
      EXPECT_EQ(std::string(error.what()), file.path().string() + ": is no MCAP file");
    }
  }
  EXPECT_THROW(McapReader("/nowhere/at/all"), McapError);
  EXPECT_THROW(McapReader("/tmp"), McapError);
}

}  // namespace
}  // namespace tacit
