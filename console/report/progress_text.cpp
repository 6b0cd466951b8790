#include "console/report/progress_text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace tacit {
namespace {

std::string rounded(double number) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), number < 10.0 ? "%.1f" : "%.0f", number);
  return text.data();
}

}  // namespace

std::optional<double> seconds_left(const Progress& progress) {
  if (progress.ticks_per_s <= 0.0 || progress.last_tick < progress.tick) {
    return std::nullopt;
  }
  return static_cast<double>(progress.last_tick - progress.tick) / progress.ticks_per_s;
}

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  const long long hours = whole / 3600;
  std::array<char, 64> text{};
  if (hours > 0) {
    std::snprintf(text.data(), text.size(), "%lld:%02lld:%02lld", hours, whole / 60 % 60,
                  whole % 60);
  } else {
    std::snprintf(text.data(), text.size(), "%lld:%02lld", whole / 60, whole % 60);
  }
  return text.data();
}

std::string progress_text(const Progress& progress) {
  std::string text = "tick " + std::to_string(progress.tick);
  if (progress.last_tick > 0) {
    text += '/' + std::to_string(progress.last_tick);
  }
  if (const auto left = seconds_left(progress)) {
    text += "  ETA " + clock_text(*left);
  }
  if (progress.ticks_per_s > 0.0) {
    text += "  " + rounded(progress.ticks_per_s) + " ticks/s (" +
            rounded(progress.ticks_per_s * progress.tick_s) + "x)";
  }
  return text + "  created " + std::to_string(progress.created) + " intercepted " +
         std::to_string(progress.intercepted) + " successful " +
         std::to_string(progress.successful);
}

}  // namespace tacit
