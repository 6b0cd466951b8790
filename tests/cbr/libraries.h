#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "idl/types/random.h"
#include "wizard_service/cbr/case.h"
#include "wizard_service/cbr/features.h"

namespace tacit::cbr {

inline CaseFeatures random_features(Stream& chance) {
  CaseFeatures features;
  for (const FeatureRow& row : feature_table()) {
    set_code(features, row.feature, chance.below(row.values.size()));
  }
  return features;
}

/// Cases 1, 2, …; every second one has no standing yet.
inline std::vector<CaseHead> random_library(std::uint64_t seed, std::size_t size) {
  Stream chance(seed, "case library");
  std::vector<CaseHead> library;
  for (CaseId id = 1; id <= size; ++id) {
    CaseHead head{id, random_features(chance), 0};
    if (chance.below(2) == 0) head.standing = static_cast<int>(chance.below(2001)) - 1000;
    head.mark = chance.below(3);
    library.push_back(head);
  }
  return library;
}

/// What of `features` is kept when each is left open with a chance of one in `openings`.
inline Query random_query(Stream& chance, std::uint64_t openings) {
  const CaseFeatures features = random_features(chance);
  Query query;
  if (chance.below(openings) != 0) query.task = features.task;
  if (chance.below(openings) != 0) query.robots = features.robots;
  if (chance.below(openings) != 0) query.localization = features.localization;
  if (chance.below(openings) != 0) query.environment = features.environment;
  if (chance.below(openings) != 0) query.handles_enemy = features.handles_enemy;
  return query;
}

inline Query query_of(const CaseFeatures& features) {
  return {features.task, features.robots, features.localization, features.environment,
          features.handles_enemy};
}

inline void shuffle(std::vector<CaseHead>& library, std::uint64_t seed) {
  Stream chance(seed, "shuffle");
  for (std::size_t i = library.size(); i > 1; --i) {
    std::swap(library[i - 1], library[chance.below(i)]);
  }
}

}  // namespace tacit::cbr
