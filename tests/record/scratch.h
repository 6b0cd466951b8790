#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace tacit {

/// A test with a folder of its own that goes when the test ends.
class ScratchTest : public testing::Test {
 protected:
  ScratchTest() { std::filesystem::create_directories(folder); }
  ~ScratchTest() override { std::filesystem::remove_all(folder); }

  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("tacit-test-" + std::to_string(::getpid()) + "-" +
       testing::UnitTest::GetInstance()->current_test_info()->name());
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// A new file each time: a disk takes its time over one whose text is replaced.
inline void put(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::remove(file);
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

/// What an exception of type `Error` said, or a remark that none was thrown.
template <class Error, class Act>
std::string complaint(Act act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no complaint)";
}

}  // namespace tacit
