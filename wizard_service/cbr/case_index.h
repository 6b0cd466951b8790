#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "wizard_service/cbr/case.h"
#include "wizard_service/cbr/rank.h"

namespace tacit::cbr {

/// The discrimination tree over cases: a level for each feature, heaviest first, cases of the same
/// features in one leaf, best standing first.
///
/// Each node knows the best standing below it, so that a search that always follows the most
/// promising node meets cases in the exact order of their ranks and ends when it has enough; what
/// it does not visit cannot be among them.
class CaseIndex {
 public:
  CaseIndex();
  explicit CaseIndex(std::span<const CaseHead> cases);
  ~CaseIndex();
  CaseIndex(CaseIndex&&) noexcept;
  CaseIndex& operator=(CaseIndex&&) noexcept;

  /// Its features are in range; no case of that id is in it.
  void insert(const CaseHead& head);
  /// Returns false when no case has that id.
  bool erase(CaseId id);
  /// Puts it in the place of the case of the same id.
  void update(const CaseHead& head);
  [[nodiscard]] std::size_t size() const;

  /// The `most` best cases, in the order of `better`.
  [[nodiscard]] std::vector<Ranked> retrieve(const Query& query, std::size_t most) const;

 private:
  class Tree;
  std::unique_ptr<Tree> tree_;
};

/// The same by looking at every case: the reference for speed and for correctness.
[[nodiscard]] std::vector<Ranked> retrieve_by_scan(std::span<const CaseHead> cases,
                                                   const Query& query, std::size_t most);

}  // namespace tacit::cbr
