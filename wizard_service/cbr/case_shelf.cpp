#include "wizard_service/cbr/case_shelf.h"

#include <string>
#include <utility>

#include "idl/types/config_error.h"
#include "wizard_service/cbr/plan_cdl.h"
#include "wizard_service/cbr/rank.h"

namespace tacit::cbr {

CaseShelf::CaseShelf(std::vector<Case> cases) : cases_(std::move(cases)) {
  std::vector<CaseHead> heads;
  for (Case& one : cases_) {
    one.id = heads.size() + 1;
    heads.push_back(
        {one.id, one.features, standing(one.record), mark(one.features, mission_text(one.plan))});
  }
  index_ = CaseIndex(heads);
}

const Case& CaseShelf::find(CaseId id) {
  if (id < 1 || id > cases_.size()) {
    throw ConfigError("case " + std::to_string(id) + " is not there");
  }
  return cases_[id - 1];
}

}  // namespace tacit::cbr
