#include "deploy/experiment/preview.h"

#include <algorithm>
#include <utility>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

void refuse_mistakes(const Setup& setup, const PreviewWish& wish) {
  if (setup.world.mission != MissionKind::Operation) {
    throw ConfigError("a preview: found the scenario \"" + setup.run.name +
                      "\", wanted an operation, a mission (.cdl) on a map");
  }
  if (wish.flights < 1 || wish.flights > kMostFlights) {
    throw ConfigError("a preview: found " + std::to_string(wish.flights) +
                      " flights, wanted 1 to " + std::to_string(kMostFlights));
  }
}

void note(std::vector<Weakness>& weaknesses, const SubTask& task, std::uint64_t seed) {
  const auto known = std::find_if(weaknesses.begin(), weaknesses.end(),
                                  [&](const Weakness& one) { return one.name == task.name; });
  if (known == weaknesses.end()) {
    weaknesses.push_back({task.name, 1, seed, task.evidence});
  } else {
    ++known->flights;
  }
}

}  // namespace

std::optional<Estimate> Preview::success() const {
  const auto full =
      std::count_if(flights.begin(), flights.end(), [](const Flight& f) { return f.full(); });
  return share_estimate(static_cast<std::size_t>(full), flights.size());
}

bool Preview::alike() const {
  return flights.size() > 1 &&
         std::all_of(flights.begin(), flights.end(), [&](const Flight& flight) {
           return flight.time_s == flights.front().time_s &&
                  flight.list.tasks == flights.front().list.tasks;
         });
}

std::vector<double> Preview::scores() const {
  std::vector<double> scores;
  for (const Flight& flight : flights) scores.push_back(flight.list.score());
  return scores;
}

std::vector<double> Preview::times_s() const {
  std::vector<double> times_s;
  for (const Flight& flight : flights) times_s.push_back(flight.time_s);
  return times_s;
}

std::optional<Estimate> Preview::score() const { return score_estimate(scores()); }

std::optional<Estimate> Preview::time_s() const { return median_estimate(times_s()); }

std::vector<Weakness> Preview::weaknesses() const {
  std::vector<Weakness> weaknesses;
  for (const Flight& flight : flights) {
    for (const SubTask& task : flight.list.tasks) {
      if (!task.done) note(weaknesses, task, flight.seed);
    }
  }
  std::stable_sort(weaknesses.begin(), weaknesses.end(),
                   [](const Weakness& a, const Weakness& b) { return a.flights > b.flights; });
  return weaknesses;
}

Preview preview(const Setup& setup, const PreviewWish& wish, const CrewOptions& options,
                const std::stop_token& stop) {
  refuse_mistakes(setup, wish);
  Preview preview;
  preview.wanted = wish.flights;
  for (std::optional<Flight>& flight :
       made_by_crew(wish.flights, options, stop,
                    [&](std::size_t i) { return fly(setup, wish.seed + i, stop); })) {
    if (flight) preview.flights.push_back(std::move(*flight));
  }
  return preview;
}

}  // namespace tacit
