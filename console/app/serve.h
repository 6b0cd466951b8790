#pragma once

namespace tacit {

/// `console serve …`: the page, the REST interface and the sockets, until SIGINT or SIGTERM.
/// Returns the exit code.
[[nodiscard]] int serve(int argc, char** argv);

}  // namespace tacit
