#include "console/record/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "console/record/record_error.h"

namespace tacit {
namespace {

constexpr mode_t kReadableByAll = 0644;

void write_new_file(const std::filesystem::path& file, std::string_view text) {
  const Descriptor out(file, O_WRONLY | O_CREAT | O_TRUNC);
  write_all(out.get(), text, file);
}

}  // namespace

Descriptor::Descriptor(const std::filesystem::path& file, int flags)
    : fd_(::open(file.c_str(), flags | O_CLOEXEC, kReadableByAll)) {
  if (fd_ < 0) {
    throw RecordError(file, system_reason());
  }
}

Descriptor::~Descriptor() {
  if (fd_ >= 0) {
    ::close(fd_);
  }
}

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

std::string system_reason() { return std::generic_category().message(errno); }

void write_all(int fd, std::string_view text, const std::filesystem::path& file) {
  while (!text.empty()) {
    const ssize_t written = ::write(fd, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      throw RecordError(file, "cannot be written: " + system_reason());
    }
  }
}

void write_whole_file(const std::filesystem::path& file, std::string_view text) {
  auto draft = file;
  draft += ".part" + std::to_string(::getpid());
  try {
    write_new_file(draft, text);
  } catch (const RecordError&) {
    ::unlink(draft.c_str());
    throw;
  }
  if (::rename(draft.c_str(), file.c_str()) != 0) {
    const std::string reason = system_reason();
    ::unlink(draft.c_str());
    throw RecordError(file, reason);
  }
}

void sync_file(const std::filesystem::path& file) {
  const Descriptor open_file(file, O_RDONLY);
  if (::fsync(open_file.get()) != 0) {
    throw RecordError(file, system_reason());
  }
}

std::string read_whole_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()).good()) {
    // An empty file sets failbit as well, and is fine.
    if (!in.is_open() || in.bad() || std::filesystem::is_directory(file)) {
      throw RecordError(file, in.is_open() ? "cannot be read" : system_reason());
    }
  }
  return text.str();
}

}  // namespace tacit
