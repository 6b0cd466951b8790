#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace tacit {

/// A recording could not be written or read. The text names the file and the reason.
class McapError : public std::runtime_error {
 public:
  McapError(const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error(file.string() + ": " + reason) {}
};

}  // namespace tacit
