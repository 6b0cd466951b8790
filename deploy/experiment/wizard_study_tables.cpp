#include "deploy/experiment/wizard_study_tables.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "console/report/estimate.h"
#include "deploy/experiment/results.h"

namespace tacit {
namespace {

using Group = std::vector<const StudyFlight*>;

std::map<std::pair<int, Planner>, Group> groups_of(std::span<const StudyFlight> flights) {
  std::map<std::pair<int, Planner>, Group> groups;
  for (const StudyFlight& one : flights) groups[{one.robots, one.planner}].push_back(&one);
  return groups;
}

template <class Truth>
TableCell share_of(const Group& group, Truth truth) {
  const auto count = std::count_if(group.begin(), group.end(),
                                   [&](const StudyFlight* one) { return truth(*one); });
  return cell_of(share_estimate(static_cast<std::size_t>(count), group.size()));
}

/// With its interval when there are enough for one.
TableCell either(const std::optional<Estimate>& estimate, const std::optional<double>& value) {
  return estimate ? cell_of(estimate) : cell_of(value);
}

TableCell score_of(const Group& group) {
  std::vector<double> scores;
  for (const StudyFlight* one : group) scores.push_back(one->score());
  return either(score_estimate(scores), mean(scores));
}

TableCell time_of(const Group& group) {
  std::vector<double> times_s;
  for (const StudyFlight* one : group) {
    if (one->refusal.empty()) times_s.push_back(one->flight.time_s);
  }
  return either(median_estimate(times_s), median(times_s));
}

/// "Enter Library, Test object 2", or why there was nothing to fly.
std::string missing(const StudyFlight& one) {
  std::string text = one.refusal;
  for (const SubTask& task : one.flight.list.tasks) {
    if (!task.done) text += (text.empty() ? "" : ", ") + task.name;
  }
  return text;
}

/// With the reasons.
std::string reasons(const StudyFlight& one) {
  std::string text = one.refusal;
  for (const std::string& failure : one.flight.failures()) {
    text += (text.empty() ? "" : " | ") + failure;
  }
  return text;
}

std::int64_t whole(std::size_t count) { return static_cast<std::int64_t>(count); }

}  // namespace

Table study_table(std::span<const StudyFlight> flights) {
  Table table{"Sub-tasks that plans get done",
              {{"robots", "robots"},
               {"planner", "planner"},
               {"flights", "flights"},
               {"score", "mean score", 3, true},
               {"good", "90 % or more", 3, true},
               {"full", "all done", 3, true},
               {"time_s", "median time (s)", 0, true}},
              {}};
  for (const auto& [key, group] : groups_of(flights)) {
    table.rows.push_back(
        {std::int64_t{key.first}, std::string(word(key.second)), whole(group.size()),
         score_of(group),
         share_of(group, [](const StudyFlight& one) { return one.score() >= kGoodScore; }),
         share_of(group, [](const StudyFlight& one) { return one.full(); }), time_of(group)});
  }
  return table;
}

Table study_failures(std::span<const StudyFlight> flights) {
  Table table{"What was not done",
              {{"robots", "robots"},
               {"planner", "planner"},
               {"site", "site"},
               {"score", "score", 3},
               {"missing", "missing"}},
              {}};
  for (const StudyFlight& one : flights) {
    if (one.full() || one.planner == Planner::Naive) continue;
    table.rows.push_back({std::int64_t{one.robots}, std::string(word(one.planner)),
                          static_cast<std::int64_t>(one.flight.seed), one.score(), missing(one)});
  }
  return table;
}

Table study_flights_table(std::span<const StudyFlight> flights, const std::string& version) {
  Table table{"Flights",
              {{"robots", "robots"},
               {"planner", "planner"},
               {"site", "site"},
               {"done", "done"},
               {"wanted", "wanted"},
               {"score", "score", 3},
               {"time_s", "time (s)", 1},
               {"missing", "missing"},
               {"version", "version"}},
              {}};
  for (const StudyFlight& one : flights) {
    table.rows.push_back({std::int64_t{one.robots}, std::string(word(one.planner)),
                          static_cast<std::int64_t>(one.flight.seed), whole(one.flight.list.done()),
                          whole(one.flight.list.wanted()), one.score(), one.flight.time_s,
                          reasons(one), version});
  }
  return table;
}

}  // namespace tacit
