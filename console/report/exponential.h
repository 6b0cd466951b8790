#pragma once

namespace tacit {

/// e to the power of x, with the same bits on every machine; to 1e-15 relative. Below -700 it is 0;
/// above 700 it stays at e^700.
[[nodiscard]] double exponential(double x);

}  // namespace tacit
