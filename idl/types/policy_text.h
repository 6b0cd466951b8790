#pragma once

#include <string>

namespace tacit {

/// What a robot has learned, in its learner's format, and where the text came from.
struct PolicyText {
  std::string text;
  std::string name;  ///< For errors; mostly a file.
};

}  // namespace tacit
