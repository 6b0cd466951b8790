#pragma once

#include <stdexcept>
#include <string>

namespace tacit {

/// A person's mistake, found before tick 0. The text says where it is, what was found and what was
/// wanted.
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(const std::string& text) : std::runtime_error(text) {}
};

}  // namespace tacit
