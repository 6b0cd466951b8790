#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "idl/types/plan_request.h"
#include "wizard_service/cbr/case_index.h"
#include "wizard_service/cbr/terrain.h"

namespace tacit::cbr {

/// Robots that do the same tasks together, one after another.
struct Squad {
  int robots = 1;
  std::vector<std::size_t> tasks;  ///< Indices of the request's.
};

/// Who is to do what, and after which cases.
struct Outline {
  std::string arrangement;  ///< A sentence.
  std::vector<Squad> squads;
  std::vector<Ranked> cases;  ///< By task of the request.
  std::int64_t rank = 0;      ///< The mean of the cases'.
};

/// The ways to share tasks out among robots, with the best cases for each, best first; at most
/// `most` of each way.
///
/// With one robot, or all together, every robot does every task in order (MissionLab's type II).
/// Several tasks are shared out among several robots, neighbours on the way together: one each when
/// there are as many (type I), more tasks than robots in shares of about the same length. When the
/// number of robots is open, it is tried as the best cases have it.
///
/// The rank of an outline is the mean of its cases', not MissionLab's mean of two again and again,
/// in which the last task counts as much as all before it. Throws ConfigError when there is no case
/// for a task.
[[nodiscard]] std::vector<Outline> propose(const PlanRequest& request, const Terrain& terrain,
                                           const CaseIndex& index, std::size_t most);

}  // namespace tacit::cbr
