#pragma once

#include <cstdint>

namespace tacit {

/// Who has given a parameter its value; a later one has the say over an earlier one.
enum class Given : std::uint8_t {
  Nobody,  ///< It is as by default.
  File,
  Set,  ///< `ScenarioFile::set`: the command line, or an experiment.
};

}  // namespace tacit
