#include "console/record/append_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <utility>

#include "console/record/record_error.h"

namespace tacit {
namespace {

/// How many bytes of the file are whole lines.
std::uint64_t whole_lines(int fd, std::uint64_t size, const std::filesystem::path& path) {
  constexpr std::uint64_t kBlock = 1 << 16;
  std::string block;
  for (std::uint64_t end = size; end > 0;) {
    const std::uint64_t begin = end - std::min(end, kBlock);
    block.resize(end - begin);
    const ssize_t got = ::pread(fd, block.data(), block.size(), static_cast<off_t>(begin));
    if (got != static_cast<ssize_t>(block.size())) {
      throw RecordError(path, "cannot be read: " + system_reason());
    }
    const auto newline = block.rfind('\n');
    if (newline != std::string::npos) {
      return begin + newline + 1;
    }
    end = begin;
  }
  return 0;
}

}  // namespace

AppendFile::AppendFile(std::filesystem::path file)
    : path_(std::move(file)), file_(path_, O_RDWR | O_CREAT | O_APPEND) {
  if (::flock(file_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw RecordError(path_, "another process is writing to it");
  }
  const off_t end = ::lseek(file_.get(), 0, SEEK_END);
  if (end < 0) {
    throw RecordError(path_, system_reason());
  }
  size_ = static_cast<std::uint64_t>(end);
  if (const auto whole = whole_lines(file_.get(), size_, path_); whole != size_) {
    cut_to(whole);
  }
}

void AppendFile::append(std::string_view lines) {
  try {
    write_all(file_.get(), lines, path_);
  } catch (const RecordError&) {
    // Should this fail too, whoever opens the file next cuts off the torn line.
    static_cast<void>(::ftruncate(file_.get(), static_cast<off_t>(size_)));
    throw;
  }
  size_ += lines.size();
}

void AppendFile::cut_to(std::uint64_t size) {
  if (::ftruncate(file_.get(), static_cast<off_t>(size)) != 0) {
    throw RecordError(path_, "cannot be cut to its last whole line: " + system_reason());
  }
  size_ = size;
}

}  // namespace tacit
