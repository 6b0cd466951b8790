#pragma once

#include <compare>
#include <cstdint>
#include <string_view>

#include "wizard_service/cbr/case.h"
#include "wizard_service/cbr/features.h"

namespace tacit::cbr {

/// Whole stars in the units of a rank.
inline constexpr std::int64_t kStar = 2'520'000;

/// How well a case fits, in units of 1 / kStar stars; all arithmetic is whole, so that every way
/// of ranking gives the same order.
///
/// 5 stars times the weighted share of the query's features that match, rounded down, plus the
/// case's standing. A number of robots that differs by d counts 1 / (1 + d), everything else all or
/// nothing. A query that leaves everything open gives 5 stars. [ours: in place of MissionLab's one
/// star a level of backtracking, which depends on the order in which the tree was grown]
[[nodiscard]] std::int64_t rank(const Query& query, const CaseFeatures& features, int standing);

/// Of a share per hundredth of weight: lcm(1, …, 10), so that 1 / (1 + d) of it is whole.
inline constexpr std::int64_t kShareUnit = 2520;

/// What one feature adds to the sum of weights, and its most; nothing when it was left open.
struct Share {
  std::int64_t got = 0;
  std::int64_t most = 0;
};
[[nodiscard]] Share share_of(const Query& query, Feature feature, std::size_t code_found);

/// The rank for the sums over all features; it grows with `got` and with `standing`.
[[nodiscard]] std::int64_t rank_of(const Share& all, int standing);

/// The effect of what a case's use has taught, in thousandths of a star, -1000 to 1000: the mean
/// outcome with one good and one bad one added, so that a single run does not decide; rounded
/// towards 0.
[[nodiscard]] int standing(const TrackRecord& record);

/// Of a case of these features whose plan is written so: others have the same hardly ever.
[[nodiscard]] std::uint64_t mark(const CaseFeatures& features, std::string_view plan);

/// Takes in one outcome: `score` 0 to 1, of a debrief or of a person (1 good, 0 bad); what lies
/// outside counts as the nearer end.
void take_outcome(TrackRecord& record, double score);
/// Remembers a failure; the oldest goes when there are too many.
void remember_failure(TrackRecord& record, Failure failure);

/// A case with its rank. Better ones first; of equals those with the smaller mark, then older ones.
struct Ranked {
  CaseId id = 0;
  CaseFeatures features;
  std::int64_t rank = 0;
  std::uint64_t mark = 0;
  friend bool operator==(const Ranked&, const Ranked&) = default;
};
[[nodiscard]] inline bool better(const Ranked& a, const Ranked& b) {
  if (a.rank != b.rank) return a.rank > b.rank;
  return a.mark != b.mark ? a.mark < b.mark : a.id < b.id;
}

}  // namespace tacit::cbr
