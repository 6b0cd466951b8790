#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "idl/bus/sieve.h"
#include "idl/types/frames.h"
#include "idl/types/ids.h"
#include "idl/types/word.h"

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

/// A joystick's displacement, at most 1 long.
template <class Vec>
Vec sieve_joystick(Sieve& sieve, double x, double y) {
  const Vec out = sieve_vec<Vec>(sieve, x, y, 1.0, "joystick is not within 1");
  sieve.pass(out.squared_norm() <= 1.0 + 1e-9, "joystick is not within 1");
  return out;
}

/// A `Word` as octets on the wire: its letters and a 0; what comes after that is not read.
using WireWord = std::array<std::uint8_t, Word::kMaxLength + 1>;

inline void word_to_wire(const Word& word, WireWord& wire) {
  const std::string_view text = word.text();
  std::fill(std::copy(text.begin(), text.end(), wire.begin()), wire.end(), std::uint8_t{0});
}

inline Word sieve_word(Sieve& sieve, std::string_view text) {
  const bool sound = sieve.pass(Word::fits(text), "word is not 0 to 63 printable characters");
  return sound ? Word(text) : Word();
}

inline Word sieve_word(Sieve& sieve, const WireWord& wire) {
  const std::string letters(wire.begin(), std::find(wire.begin(), wire.end(), 0));
  return sieve_word(sieve, letters);
}

}  // namespace tacit
