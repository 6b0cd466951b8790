#include "console/record/sha256.h"

#include "console/record/record_error.h"
#include "tests/record/scratch.h"

namespace tacit {
namespace {

using Sha256Test = ScratchTest;

// FIPS 180-4, examples published by NIST.
TEST(Sha256, GivesThePublishedDigests) {
  EXPECT_EQ(sha256_of_text("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_text("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of_text(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, GoesOnAfterADigestWasTaken) {
  Sha256 hash;
  hash.add("a");
  EXPECT_EQ(hash.hex(), sha256_of_text("a"));
  hash.add("bc");
  EXPECT_EQ(hash.hex(), sha256_of_text("abc"));
}

TEST_F(Sha256Test, OfAFileIsThatOfItsText) {
  const std::string text(200'000, 'x');
  put(folder / "f", text);

  EXPECT_EQ(sha256_of_file(folder / "f"), sha256_of_text(text));
}

TEST_F(Sha256Test, OfAMissingFileNamesIt) {
  EXPECT_EQ(complaint<RecordError>([&] { (void)sha256_of_file(folder / "nowhere"); }),
            (folder / "nowhere").string() + ": No such file or directory");
}

}  // namespace
}  // namespace tacit
