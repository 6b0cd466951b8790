#pragma once

#include <functional>
#include <string>

#include "idl/types/plan_answer.h"
#include "idl/types/plan_request.h"
#include "wizard_service/app/answered.h"
#include "wizard_service/app/grounds.h"
#include "wizard_service/cases/case_base.h"
#include "wizard_service/cbr/case_index.h"
#include "wizard_service/cbr/wizard.h"

namespace tacit {

/// What the wizard does with requests, wherever they come from.
class Desk {
 public:
  using Say = std::function<void(const WizardReply&)>;

  /// Borrows the case base.
  explicit Desk(cbr::CaseBase& base) : base_(base) {}

  /// Does what is asked and says so: progress any number of times, then one last word. Throws
  /// nothing for what is wrong with a request, the case base or the machine; that is a refusal.
  void take(const WizardRequest& request, const Say& say);

 private:
  using Reply = decltype(WizardReply::what);
  class Cases;

  Reply done(const WizardRequest& request, const Say& say);
  Reply plans(const AskForPlans& ask, const cbr::Progress& progress);
  Reply outcome(const ReportOutcome& report, const cbr::ReportKey& by);
  Reply stored(const StoreMission& mission);
  Reply state();
  void look_at_cases();

  cbr::CaseBase& base_;
  cbr::CaseIndex index_;
  std::vector<std::string> flaws_;  ///< A sentence for each case that cannot be used.
  Grounds grounds_;
  Answered answered_;
};

}  // namespace tacit
