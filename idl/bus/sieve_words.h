#pragma once

#include "idl/bus/sieve.h"
#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

/// Checks that are the same for many words.

inline RobotId sieve_robot(Sieve& sieve, std::uint16_t value) {
  return {sieve.whole<std::uint16_t>(value, 1, 65535, "robot is 0, wanted 1 to 65535")};
}

inline Tick sieve_tick(Sieve& sieve, std::uint64_t value) {
  return sieve.whole<std::uint64_t>(value, 0, limits::kTick, "tick is not below 2^63");
}

template <class Vec>
Vec sieve_vec(Sieve& sieve, double x, double y, double limit, std::string_view what) {
  const double sound_x = sieve.number(x, -limit, limit, what);
  return {sound_x, sieve.number(y, -limit, limit, what)};
}

inline Heading sieve_heading(Sieve& sieve, double cos, double sin) {
  const double off = cos * cos + sin * sin - 1.0;
  sieve.pass(off >= -1e-9 && off <= 1e-9, "heading is no unit vector");
  return {cos, sin};
}

}  // namespace tacit
