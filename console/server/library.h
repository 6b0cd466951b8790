#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tacit {

/// Files of one kind that can be asked for by name, from several folders; of two of one name the
/// first counts.
class Library {
 public:
  Library(std::vector<std::filesystem::path> folders, std::string ending)
      : folders_(std::move(folders)), ending_(std::move(ending)) {}

  /// By name.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  /// Throws ConfigError with the names that there are when there is none.
  [[nodiscard]] std::filesystem::path find(const std::string& name) const;

 private:
  std::vector<std::filesystem::path> folders_;
  std::string ending_;  ///< ".ovl"
};

}  // namespace tacit
