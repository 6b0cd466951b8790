#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "idl/types/plan_answer.h"
#include "idl/types/plan_request.h"
#include "wizard_service/cbr/plan.h"

namespace tacit::cbr {

/// What went wrong once.
struct Failure {
  std::string what;  ///< Of a checklist: "Enter Library: No robot of the team was there."
  std::string map;   ///< What the map is called; may be empty.
  friend bool operator==(const Failure&, const Failure&) = default;
};

/// Failures that are kept, the newest.
inline constexpr std::size_t kFailuresKept = 5;

/// What a case's use has taught.
struct TrackRecord {
  std::uint32_t uses = 0;         ///< Plans that were proposed first and taken.
  std::uint32_t outcomes = 0;     ///< Runs that were debriefed, and people's verdicts.
  std::uint64_t good_milli = 0;   ///< Sum of the outcomes' scores, in thousandths.
  std::vector<Failure> failures;  ///< Newest last.
  friend bool operator==(const TrackRecord&, const TrackRecord&) = default;
};

/// What ranking needs of a case.
struct CaseHead {
  CaseId id = 0;
  CaseFeatures features;
  int standing = 0;  ///< In thousandths of a star, -1000 to 1000: see `standing`.
  /// Tells cases of one rank apart by what they are, whatever order they were stored in.
  std::uint64_t mark = 0;
  friend bool operator==(const CaseHead&, const CaseHead&) = default;
};

/// A piece of a mission that has been used or was written by an expert: one task's part of it.
struct Case {
  CaseId id = 0;       ///< 0: not stored yet.
  std::string title;   ///< A short line.
  std::string origin;  ///< Where it comes from: "seed", a file, "stored".
  CaseFeatures features;
  Plan plan;
  TrackRecord record;
};

/// What of a case is kept where cases are kept.
class CaseSource {
 public:
  CaseSource() = default;
  CaseSource(const CaseSource&) = delete;
  CaseSource& operator=(const CaseSource&) = delete;
  virtual ~CaseSource() = default;
  /// Throws ConfigError when there is no such case or its plan cannot be read.
  [[nodiscard]] virtual const Case& find(CaseId id) = 0;
};

}  // namespace tacit::cbr
