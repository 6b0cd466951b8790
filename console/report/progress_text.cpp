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

std::string guard_text(const Enemies& enemies) {
  return "created " + std::to_string(enemies.created) + " intercepted " +
         std::to_string(enemies.intercepted) + " successful " + std::to_string(enemies.successful);
}

std::string forage_text(const Forage& forage, std::int64_t robots) {
  const auto able = robots - static_cast<std::int64_t>(forage.disabled());
  return "mines left " + std::to_string(forage.mines_left()) + '/' +
         std::to_string(forage.mines.value_or(0)) + "  able " + std::to_string(able) + '/' +
         std::to_string(robots);
}

std::string operation_text(const Operation& operation) {
  std::string text = "rooms " + std::to_string(operation.rooms) + " tested " +
                     std::to_string(operation.tested) + " alerts " +
                     std::to_string(operation.alerts);
  if (operation.stored > 0) text += " stored " + std::to_string(operation.stored);
  return text + "  finished " + std::to_string(operation.finished) + '/' +
         std::to_string(operation.team.value_or(0));
}

std::string mission_text(const Tally& tally, std::int64_t robots) {
  const auto& operation = tally.of<Operation>();
  if (operation.team) return operation_text(operation);
  const auto& forage = tally.of<Forage>();
  return forage.mines ? forage_text(forage, robots) : guard_text(tally.of<Enemies>());
}

}  // namespace

std::string standing_text(const Tally& tally, std::int64_t robots, const std::string& doings) {
  const std::string mission = mission_text(tally, robots);
  return doings.empty() ? mission : mission + "  (" + doings + ')';
}

const std::string& doing(const Telemetry& telemetry) {
  return telemetry.role.empty() ? telemetry.situation : telemetry.role;
}

std::string doings_text(const std::map<RobotId, std::string>& doings) {
  std::map<std::string, int> robots_at;
  for (const auto& [robot, what] : doings) {
    if (!what.empty()) {
      ++robots_at[what];
    }
  }
  std::string text;
  for (const auto& [what, robots] : robots_at) {
    text += (text.empty() ? "" : ", ") + std::to_string(robots) + ' ' + what;
  }
  return text;
}

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
  return progress.standing.empty() ? text : text + "  " + progress.standing;
}

}  // namespace tacit
