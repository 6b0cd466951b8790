#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "console/report/estimate.h"
#include "deploy/experiment/crew.h"
#include "deploy/experiment/flight.h"
#include "deploy/lockstep/setup.h"

namespace tacit {

/// Flights that one preview may have.
inline constexpr std::size_t kMostFlights = 100'000;

struct PreviewWish {
  std::uint64_t seed = 1;    ///< Of the first flight; the next has the next.
  std::size_t flights = 20;  ///< 1 to kMostFlights.
};

/// A sub-task that was not always done.
struct Weakness {
  std::string name;
  std::size_t flights = 0;  ///< In which it was not.
  std::uint64_t seed = 0;   ///< Of the first of these,
  std::string evidence;     ///< and what was said of it there.
  friend bool operator==(const Weakness&, const Weakness&) = default;
};

/// What a mission is likely to come to, told from a number of flights.
struct Preview {
  std::vector<Flight> flights;  ///< By seed; those that were flown to their end.
  std::size_t wanted = 0;

  /// Whether flights are missing because it was told to stop.
  [[nodiscard]] bool cut_short() const { return flights.size() < wanted; }
  /// Whether several flights all went the same way, so that they are worth no more than one: where
  /// neither senses nor calls nor the mission draw any chance, the seed changes nothing.
  [[nodiscard]] bool alike() const;
  /// The share of flights that did every sub-task.
  [[nodiscard]] std::optional<Estimate> success() const;
  /// The mean share of sub-tasks that were done; absent below two flights.
  [[nodiscard]] std::optional<Estimate> score() const;
  /// The median simulated time, in s; absent below six flights.
  [[nodiscard]] std::optional<Estimate> time_s() const;
  /// What failed most often first; of equally frequent ones the first found.
  [[nodiscard]] std::vector<Weakness> weaknesses() const;

  [[nodiscard]] std::vector<double> scores() const;
  [[nodiscard]] std::vector<double> times_s() const;
};

/// Flies the operation that `setup` is again and again in the one-process world, on several
/// threads, and blocks meanwhile; the result is the same for any number of them. When `stop` is
/// asked for, flights under way are given up and what is finished is the result. Throws ConfigError
/// when `setup` is no operation or cannot be.
[[nodiscard]] Preview preview(const Setup& setup, const PreviewWish& wish,
                              const CrewOptions& options, const std::stop_token& stop);

}  // namespace tacit
