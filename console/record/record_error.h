#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace tacit {

/// Something could not be recorded or read back. The text names the file and the reason.
class RecordError : public std::runtime_error {
 public:
  RecordError(const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error(file.string() + ": " + reason) {}
};

}  // namespace tacit
