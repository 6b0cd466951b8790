#pragma once

#include <string>

#include "idl/types/ids.h"

namespace tacit {

/// Who did something, and when.
struct Deed {
  RobotId robot;
  Tick tick = 0;
};

/// Ticks and seconds, and how evidence names them.
class TimeScale {
 public:
  /// A tick takes `tick_s` seconds, above 0.
  explicit TimeScale(double tick_s);

  [[nodiscard]] Tick ticks(double seconds) const;
  /// "12.5 s"
  [[nodiscard]] std::string seconds(Tick ticks) const;
  /// "at tick 125 (12.5 s)"
  [[nodiscard]] std::string at(Tick tick) const;
  /// "Robot 2 was there at tick 125 (12.5 s)", for "was there".
  [[nodiscard]] std::string told(const Deed& deed, const std::string& what) const;

 private:
  double tick_s_;
};

}  // namespace tacit
