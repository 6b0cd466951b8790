#pragma once

#include <filesystem>
#include <string>

namespace tacit {

/// A folder of its own among the system's temporary files that goes, with all it holds, when this
/// goes. Only this user can look into it.
class TemporaryFolder {
 public:
  /// Its name begins with `name`. Throws std::runtime_error when it cannot be made.
  explicit TemporaryFolder(const std::string& name);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tacit
