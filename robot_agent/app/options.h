#pragma once

#include <cstdint>
#include <filesystem>
#include <variant>

namespace tacit {

/// What the command line of an agent says.
struct Options {
  std::uint16_t id = 0;
  std::filesystem::path scenario;
  std::filesystem::path memory;   ///< Empty: a process that dies cannot be taken over.
  std::filesystem::path inherit;  ///< Empty: nothing was learned before.
  std::filesystem::path learned;  ///< Empty: what is learned ends with the process.
  int domain = 1;
  std::uint32_t run_nonce = 0;
  double patience_s = 30.0;
};

/// The options, or the exit code of a program that has nothing more to do.
[[nodiscard]] std::variant<Options, int> read_options(int argc, char** argv);

}  // namespace tacit
