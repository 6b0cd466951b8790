#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tacit {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  /// Throws RecordError. `flags` as for open(2).
  Descriptor(const std::filesystem::path& file, int flags);
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;

  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

/// What went wrong in the last system call, in words.
[[nodiscard]] std::string system_reason();

/// Writes all of `text`; throws RecordError.
void write_all(int fd, std::string_view text, const std::filesystem::path& file);

/// Replaces `file` by one that holds `text`. Whoever opens it finds the old text or the new, never
/// a part, also when this process is killed. Throws RecordError; the old text then stays.
void write_whole_file(const std::filesystem::path& file, std::string_view text);

/// Returns once `file`, which may be a folder, outlasts the machine's power. On a busy disk that
/// takes seconds. Throws RecordError.
void sync_file(const std::filesystem::path& file);

/// Throws RecordError.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& file);

}  // namespace tacit
