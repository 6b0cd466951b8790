#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "console/record/files.h"

namespace tacit {

/// A file of lines that only grows, written by one process at a time.
///
/// What `append` has returned for outlives the process, however it ends.
class AppendFile {
 public:
  /// Opens or creates `file` and cuts off a last line without its newline, left by a process that
  /// died while it wrote. Throws RecordError, also when another process is writing to it.
  explicit AppendFile(std::filesystem::path file);

  /// Appends whole lines: all of them or, when it throws RecordError, none.
  void append(std::string_view lines);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// In bytes.
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  void cut_to(std::uint64_t size);

  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;
};

}  // namespace tacit
