#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tacit {

/// What the console's command line asks for.
struct Options {
  std::filesystem::path scenario;  ///< As resolved. Not used with `resume`.
  std::filesystem::path out;
  std::filesystem::path store;  ///< Empty for none.
  std::filesystem::path tape;   ///< An MCAP file; empty for none.
  int domain = 1;
  std::uint32_t run_nonce = 0;
  bool resume = false;
  bool trajectories = false;
  bool quiet = false;
  double patience_s = 20.0;
  std::string key;                        ///< Empty: made up.
  std::vector<std::string> command_line;  ///< To be noted as what started the run.
};

/// Reads the command line; an exit code when all has been said already.
[[nodiscard]] std::variant<Options, int> read_options(int argc, char** argv);

}  // namespace tacit
