#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "robot_agent/brain/fsa/entry.h"

namespace tacit {

/// Where a behaviour stands, as numbers in an order that only it knows.
class Record {
 public:
  void add(double value) { values_.push_back(value); }
  /// Whole numbers up to 2^53.
  void add_count(std::uint64_t value) { add(static_cast<double>(value)); }
  void add(const Entry& entry) {
    add_count(entry.tick);
    add(entry.pose.position_m.x());
    add(entry.pose.position_m.y());
    add(entry.pose.heading.cos);
    add(entry.pose.heading.sin);
  }
  [[nodiscard]] std::span<const double> values() const { return values_; }

 private:
  std::vector<double> values_;
};

/// Reads a record from its beginning; `sound` turns false at the first value that cannot be.
class RecordReader {
 public:
  explicit RecordReader(std::span<const double> values) : rest_(values) {}

  [[nodiscard]] double number() {
    if (rest_.empty()) {
      sound_ = false;
      return 0.0;
    }
    const double value = rest_.front();
    rest_ = rest_.subspan(1);
    sound_ = sound_ && std::isfinite(value);
    return value;
  }
  /// A whole number below `limit`.
  [[nodiscard]] std::uint64_t count(std::uint64_t limit) {
    const double value = number();
    sound_ =
        sound_ && value >= 0.0 && value < static_cast<double>(limit) && value == std::floor(value);
    return sound_ ? static_cast<std::uint64_t>(value) : 0;
  }
  [[nodiscard]] Entry entry() {
    Entry entry;
    entry.tick = count(kMostTicks);
    const double x = number();
    const double y = number();
    entry.pose.position_m = {x, y};
    entry.pose.heading.cos = number();
    entry.pose.heading.sin = number();
    return entry;
  }
  [[nodiscard]] bool sound() const { return sound_; }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  static constexpr std::uint64_t kMostTicks = std::uint64_t{1} << 53;

 private:
  std::span<const double> rest_;
  bool sound_ = true;
};

}  // namespace tacit
