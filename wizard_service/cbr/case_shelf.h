#pragma once

#include <vector>

#include "wizard_service/cbr/case.h"
#include "wizard_service/cbr/case_index.h"

namespace tacit::cbr {

/// Cases in memory, numbered from 1 in their order. Nothing of it changes any more, so several
/// threads may look into one at once.
class CaseShelf final : public CaseSource {
 public:
  explicit CaseShelf(std::vector<Case> cases);
  [[nodiscard]] const Case& find(CaseId id) override;
  [[nodiscard]] const CaseIndex& index() const { return index_; }

 private:
  std::vector<Case> cases_;
  CaseIndex index_;
};

}  // namespace tacit::cbr
