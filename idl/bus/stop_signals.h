#pragma once

#include "idl/bus/bell.h"

namespace tacit {

/// While it lives, SIGINT and SIGTERM ring `bell` and are remembered. One at a time.
class StopSignals {
 public:
  explicit StopSignals(Bell& bell);
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  [[nodiscard]] static bool came();
};

}  // namespace tacit
