#include "console/debrief/time_scale.h"

#include <array>
#include <cassert>
#include <charconv>

namespace tacit {

TimeScale::TimeScale(double tick_s) : tick_s_(tick_s) { assert(tick_s > 0.0); }

Tick TimeScale::ticks(double seconds) const { return static_cast<Tick>(seconds / tick_s_ + 0.5); }

std::string TimeScale::seconds(Tick ticks) const {
  std::array<char, 400> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                 static_cast<double>(ticks) * tick_s_, std::chars_format::fixed, 1)
                       .ptr;
  return std::string(digits.data(), end) + " s";
}

std::string TimeScale::at(Tick tick) const {
  return "at tick " + std::to_string(tick) + " (" + seconds(tick) + ")";
}

std::string TimeScale::told(const Deed& deed, const std::string& what) const {
  return "Robot " + std::to_string(deed.robot.value) + " " + what + " " + at(deed.tick);
}

}  // namespace tacit
