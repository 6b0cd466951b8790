#pragma once

#include <string>

#include "idl/types/config_error.h"

namespace tacit {

/// Throws ConfigError if something is `wrong` with a configuration.
inline void refuse(bool wrong, const std::string& text) {
  if (wrong) {
    throw ConfigError(text);
  }
}

}  // namespace tacit
