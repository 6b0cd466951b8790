#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>

namespace tacit {

/// What the command line of a world server says.
struct Options {
  std::filesystem::path scenario;
  int domain = 1;
  std::uint32_t run_nonce = 0;
  double speed = 0.0;                       ///< Times real time; 0: as fast as it goes.
  std::optional<std::int64_t> patience_ms;  ///< 0: without end. Absent: by the speed.
  std::optional<double> duration_s;         ///< In place of the scenario's.
  double view_hz = 20.0;
  double gather_s = 60.0;
  bool trajectories = false;
  bool await_console = false;
};

/// The options, or the exit code of a program that has nothing more to do.
[[nodiscard]] std::variant<Options, int> read_options(int argc, char** argv);

}  // namespace tacit
