#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "idl/types/policy_text.h"

namespace tacit {

/// What the robots of a team have learned, a file for each: robot_1.json, robot_2.json, …
class PolicyFolder {
 public:
  explicit PolicyFolder(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path file_of(std::int64_t robot) const;

  /// Of the robots that have one, in order.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  /// Robot i+1 at index i; empty when the folder is not there or holds no policies. Throws
  /// ConfigError when it holds those of another team than robots 1 to `robots`, or one cannot be
  /// read.
  [[nodiscard]] std::vector<PolicyText> load(std::int64_t robots) const;
  /// Puts robot i+1's in place of what its file held, in one step; makes the folder if need be.
  /// Throws RecordError.
  void save(const std::vector<std::string>& policies) const;

 private:
  [[nodiscard]] std::vector<std::int64_t> robots_there() const;

  std::filesystem::path path_;
};

}  // namespace tacit
