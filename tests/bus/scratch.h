#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>

namespace tacit::test {

/// A test with a folder of its own that goes when the test ends.
class ScratchTest : public testing::Test {
 protected:
  ScratchTest() {
    char name[] = "/tmp/tacit-memory-XXXXXX";
    folder_ = mkdtemp(name);
  }
  ~ScratchTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

}  // namespace tacit::test
