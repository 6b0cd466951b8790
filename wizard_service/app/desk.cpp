#include "wizard_service/app/desk.h"

#include <chrono>
#include <exception>
#include <utility>

#include "idl/types/config_error.h"
#include "wizard_service/cbr/plan_cdl.h"
#include "wizard_service/cbr/store.h"
#include "wizard_service/cbr/wizard.h"

namespace tacit {
namespace {

constexpr std::chrono::milliseconds kProgressPeriod{200};

/// A case that turned out to be unusable while a plan was made from it.
struct BadCase {
  CaseId id;
  std::string why;
};

std::string flaw_text(CaseId id, const std::string& why) {
  return "Case " + std::to_string(id) + " was left out: " + why;
}

std::string counted(std::size_t count, const std::string& one, const std::string& more) {
  return std::to_string(count) + ' ' + (count == 1 ? one : more);
}

}  // namespace

class Desk::Cases final : public cbr::CaseSource {
 public:
  explicit Cases(cbr::CaseBase& base) : base_(base) {}
  const cbr::Case& find(CaseId id) override {
    try {
      return base_.find(id);
    } catch (const ConfigError& error) {
      throw BadCase{id, error.what()};
    }
  }

 private:
  cbr::CaseBase& base_;
};

void Desk::take(const WizardRequest& request, const Say& say) {
  if (const WizardReply* before = answered_.find(request.client, request.number)) {
    say(*before);
    return;
  }
  WizardReply reply{request.client, request.number, {}};
  try {
    reply.what = done(request, say);
  } catch (const std::exception& error) {
    reply.what = WizardRefusal{error.what()};
  }
  say(reply);
  answered_.keep(std::move(reply));
}

Desk::Reply Desk::done(const WizardRequest& request, const Say& say) {
  using Clock = std::chrono::steady_clock;
  const cbr::Progress progress = [&, last = Clock::now()](double share,
                                                          const std::string& doing) mutable {
    const Clock::time_point now = Clock::now();
    if (now - last < kProgressPeriod) return;
    last = now;
    say({request.client, request.number, WizardProgress{share, doing}});
  };
  if (const auto* ask = std::get_if<AskForPlans>(&request.what)) return plans(*ask, progress);
  if (const auto* report = std::get_if<ReportOutcome>(&request.what)) {
    return outcome(*report, {request.client, request.number});
  }
  if (const auto* mission = std::get_if<StoreMission>(&request.what)) return stored(*mission);
  return state();
}

Desk::Reply Desk::plans(const AskForPlans& ask, const cbr::Progress& progress) {
  const cbr::Terrain& terrain = grounds_.of(ask.map);
  look_at_cases();
  Cases cases(base_);
  for (;;) {
    try {
      cbr::Answer made = cbr::answer(ask.request, terrain, index_, cases, progress);
      PlanAnswer answer;
      for (cbr::Proposal& one : made.proposals) answer.plans.push_back(std::move(one.offered));
      answer.notes = std::move(made.notes);
      answer.notes.insert(answer.notes.end(), flaws_.begin(), flaws_.end());
      return answer;
    } catch (const BadCase& bad) {
      index_.erase(bad.id);
      flaws_.push_back(flaw_text(bad.id, bad.why));
    }
  }
}

Desk::Reply Desk::outcome(const ReportOutcome& report, const cbr::ReportKey& by) {
  std::vector<cbr::Failure> failures;
  for (const std::string& what : report.failures) failures.push_back({what, report.map});
  const bool fresh = base_.record_report(by, report.cases, report.score, failures);
  return WizardDone{base_.size(), fresh ? "Took in how it went." : "That was known already."};
}

Desk::Reply Desk::stored(const StoreMission& mission) {
  const cbr::Plan plan = cbr::plan_of(mission.mission, "mission");
  std::vector<cbr::Case> pieces = cbr::pieces_of(plan, mission.features, mission.title);
  for (cbr::Case& piece : pieces) piece.origin = "stored";
  std::size_t fresh = 0;
  for (const cbr::Stored& one : base_.store(pieces)) fresh += one.fresh ? 1 : 0;
  const std::size_t known = pieces.size() - fresh;
  std::string text = "Stored " + counted(fresh, "new case", "new cases");
  if (known > 0) text += "; " + counted(known, "was", "were") + " there";
  return WizardDone{base_.size(), text + '.'};
}

Desk::Reply Desk::state() {
  look_at_cases();
  std::string text = "Has " + counted(index_.size(), "case", "cases") + '.';
  for (const std::string& flaw : flaws_) text += '\n' + flaw;
  return WizardDone{base_.size(), text};
}

void Desk::look_at_cases() {
  if (!base_.changed_since_last_look()) return;
  const cbr::Inventory all = base_.inventory();
  index_ = cbr::CaseIndex(all.heads);
  flaws_.clear();
  for (const cbr::Flaw& flaw : all.flaws) flaws_.push_back(flaw_text(flaw.id, flaw.reason));
}

}  // namespace tacit
