#include "wizard_service/cbr/rank.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace tacit::cbr {
namespace {

constexpr std::int64_t kMilli = 1000;
constexpr std::int64_t kMostStars = 5;

}  // namespace

Share share_of(const Query& query, Feature feature, std::size_t code_found) {
  const std::optional<std::size_t> wanted = code(query, feature);
  if (!wanted) return {};
  const std::int64_t weight = feature_table()[static_cast<std::size_t>(feature)].weight;
  Share share{0, weight * kShareUnit};
  if (*wanted == code_found) {
    share.got = share.most;
  } else if (feature == Feature::NumberOfRobots) {
    const std::int64_t apart =
        std::abs(static_cast<std::int64_t>(*wanted) - static_cast<std::int64_t>(code_found));
    share.got = share.most / (1 + apart);
  }
  return share;
}

std::int64_t rank_of(const Share& all, int standing) {
  const std::int64_t fit =
      all.most == 0 ? kMostStars * kStar : kMostStars * kStar * all.got / all.most;
  return fit + standing * (kStar / kMilli);
}

std::int64_t rank(const Query& query, const CaseFeatures& features, int standing) {
  Share all;
  for (const FeatureRow& row : feature_table()) {
    const Share one = share_of(query, row.feature, code(features, row.feature));
    all.got += one.got;
    all.most += one.most;
  }
  return rank_of(all, standing);
}

int standing(const TrackRecord& record) {
  const auto outcomes = static_cast<std::int64_t>(record.outcomes);
  const std::int64_t most = outcomes * kMilli;
  const auto good =
      static_cast<std::int64_t>(std::min(record.good_milli, static_cast<std::uint64_t>(most)));
  return static_cast<int>((good - (most - good)) / (outcomes + 2));
}

std::uint64_t mark(const CaseFeatures& features, std::string_view plan) {
  std::uint64_t sum = 0xcbf29ce484222325;  // FNV-1a
  const auto add = [&sum](std::uint64_t byte) { sum = (sum ^ byte) * 0x100000001b3; };
  for (const FeatureRow& row : feature_table()) add(code(features, row.feature));
  for (const char c : plan) add(static_cast<unsigned char>(c));
  return sum;
}

void take_outcome(TrackRecord& record, double score) {
  const double share = score > 0.0 ? std::min(score, 1.0) : 0.0;
  ++record.outcomes;
  record.good_milli += static_cast<std::uint64_t>(std::lround(share * kMilli));
}

void remember_failure(TrackRecord& record, Failure failure) {
  record.failures.push_back(std::move(failure));
  if (record.failures.size() <= kFailuresKept) return;
  record.failures.erase(record.failures.begin(),
                        record.failures.end() - static_cast<std::ptrdiff_t>(kFailuresKept));
}

}  // namespace tacit::cbr
