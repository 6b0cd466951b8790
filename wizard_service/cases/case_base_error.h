#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace tacit::cbr {

/// A case base could not be read or written, whatever it holds: a full disk, a missing folder. The
/// text names the file and the reason.
class CaseBaseError : public std::runtime_error {
 public:
  CaseBaseError(const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error(file.string() + ": " + reason) {}
};

}  // namespace tacit::cbr
