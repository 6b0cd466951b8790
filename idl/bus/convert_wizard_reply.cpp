#include "idl/bus/convert_wizard.h"
#include "idl/bus/sieve_texts.h"
#include "idl/wire/wizard.h"

namespace tacit {
namespace {

constexpr std::size_t kReplyText = 100'000;

enum class Kind : std::uint8_t { Progress, Plans, Done, Refusal };

void to_wire(const FeatureMatch& word, wire::FeatureMatch& wire) {
  wire.feature(cut(word.feature, kShortText));
  wire.wanted(cut(word.wanted, kShortText));
  wire.found(cut(word.found, kShortText));
  wire.matches(word.matches ? 1 : 0);
}

FeatureMatch sieve_match(Sieve& sieve, const wire::FeatureMatch& wire) {
  constexpr std::string_view kWhat = "a feature is too long";
  return {sieve_text(sieve, wire.feature(), kShortText, kWhat),
          sieve_text(sieve, wire.wanted(), kShortText, kWhat),
          sieve_text(sieve, wire.found(), kShortText, kWhat),
          sieve.flag(wire.matches(), "a match is neither 0 nor 1")};
}

void to_wire(const UsedCase& word, wire::UsedCase& wire) {
  wire.id(word.id);
  wire.task(static_cast<std::uint32_t>(word.task));
  wire.title(cut(word.title, kShortText));
  wire.record(cut(word.record, kShortText));
  wire.features(cut_list<wire::FeatureMatch>(
      word.features, kShortList,
      [](const FeatureMatch& from, wire::FeatureMatch& to) { to_wire(from, to); }));
}

UsedCase sieve_case(Sieve& sieve, const wire::UsedCase& wire) {
  UsedCase used;
  used.id = wire.id();
  used.task = sieve.count(wire.task(), kShortList, "a case's task is out of range");
  used.title = sieve_text(sieve, wire.title(), kShortText, "a case's title is too long");
  used.record = sieve_text(sieve, wire.record(), kShortText, "a case's record is too long");
  used.features = sieve_list<FeatureMatch>(
      sieve, wire.features(), kShortList, "too many features of a case",
      [&](const wire::FeatureMatch& match) { return sieve_match(sieve, match); });
  return used;
}

void to_wire(const PlanChange& word, wire::PlanChange& wire) {
  wire.step(static_cast<std::uint8_t>(word.step));
  wire.mended(word.mended ? 1 : 0);
  wire.rule(cut(word.rule, kShortText));
  wire.why(cut(word.why, kShortText));
  wire.before(cut(word.before, kLongText));
  wire.after(cut(word.after, kLongText));
}

PlanChange sieve_change(Sieve& sieve, const wire::PlanChange& wire) {
  constexpr std::string_view kWhat = "a change is too long";
  PlanChange change;
  change.step = sieve.code(wire.step(), PlanChange::Step::Criticize, "unknown step of a change");
  change.rule = sieve_text(sieve, wire.rule(), kShortText, kWhat);
  change.why = sieve_text(sieve, wire.why(), kShortText, kWhat);
  change.before = sieve_text(sieve, wire.before(), kLongText, kWhat);
  change.after = sieve_text(sieve, wire.after(), kLongText, kWhat);
  change.mended = sieve.flag(wire.mended(), "mended is neither 0 nor 1");
  return change;
}

void to_wire(const OfferedPlan& word, wire::OfferedPlan& wire) {
  wire.stars(word.stars);
  wire.arrangement(cut(word.arrangement, kShortText));
  wire.mission(word.mission);
  wire.cases(cut_list<wire::UsedCase>(
      word.cases, kShortList, [](const UsedCase& from, wire::UsedCase& to) { to_wire(from, to); }));
  wire.changes(cut_list<wire::PlanChange>(
      word.changes, kLongList,
      [](const PlanChange& from, wire::PlanChange& to) { to_wire(from, to); }));
}

OfferedPlan sieve_offer(Sieve& sieve, const wire::OfferedPlan& wire) {
  OfferedPlan offered;
  offered.stars = sieve.number(wire.stars(), 0.0, 5.0, "stars are not in 0 to 5");
  offered.arrangement =
      sieve_text(sieve, wire.arrangement(), kShortText, "an arrangement is too long");
  offered.mission =
      sieve_text(sieve, wire.mission(), kLongestPlanText, "a mission is longer than 4 MB");
  offered.cases =
      sieve_list<UsedCase>(sieve, wire.cases(), kShortList, "too many cases",
                           [&](const wire::UsedCase& used) { return sieve_case(sieve, used); });
  offered.changes = sieve_list<PlanChange>(
      sieve, wire.changes(), kLongList, "too many changes",
      [&](const wire::PlanChange& change) { return sieve_change(sieve, change); });
  return offered;
}

void to_wire(const WizardProgress& word, wire::WizardReply& wire) {
  wire.kind(static_cast<std::uint8_t>(Kind::Progress));
  wire.progress(word.done);
  wire.text(cut(word.doing, kReplyText));
}

void to_wire(const PlanAnswer& word, wire::WizardReply& wire) {
  wire.kind(static_cast<std::uint8_t>(Kind::Plans));
  wire.plans(cut_list<wire::OfferedPlan>(
      word.plans, kMostPlans,
      [](const OfferedPlan& from, wire::OfferedPlan& to) { to_wire(from, to); }));
  wire.notes(cut_texts(word.notes));
}

void to_wire(const WizardDone& word, wire::WizardReply& wire) {
  wire.kind(static_cast<std::uint8_t>(Kind::Done));
  wire.cases(word.cases);
  wire.text(cut(word.text, kReplyText));
}

void to_wire(const WizardRefusal& word, wire::WizardReply& wire) {
  wire.kind(static_cast<std::uint8_t>(Kind::Refusal));
  wire.text(cut(word.text, kReplyText));
}

PlanAnswer sieve_plans(Sieve& sieve, const wire::WizardReply& wire) {
  PlanAnswer answer;
  answer.plans = sieve_list<OfferedPlan>(
      sieve, wire.plans(), kMostPlans, "more than 20 plans",
      [&](const wire::OfferedPlan& plan) { return sieve_offer(sieve, plan); });
  answer.notes = sieve_texts(sieve, wire.notes(), "too many or too long notes");
  return answer;
}

}  // namespace

void to_wire(const WizardReply& word, wire::WizardReply& wire) {
  wire = {};
  wire.client(word.client);
  wire.number(word.number);
  std::visit([&](const auto& what) { to_wire(what, wire); }, word.what);
}

Flaw from_wire(const wire::WizardReply& wire, WizardReply& word) {
  Sieve sieve;
  word.client = wire.client();
  word.number = wire.number();
  const std::string text = sieve_text(sieve, wire.text(), kReplyText, "a reply is too long");
  switch (sieve.code(wire.kind(), Kind::Refusal, "unknown kind of reply")) {
    case Kind::Progress:
      word.what = WizardProgress{
          sieve.number(wire.progress(), 0.0, 1.0, "progress is not in 0 to 1"), text};
      break;
    case Kind::Plans:
      word.what = sieve_plans(sieve, wire);
      break;
    case Kind::Done:
      word.what = WizardDone{wire.cases(), text};
      break;
    case Kind::Refusal:
      word.what = WizardRefusal{text};
      break;
  }
  return sieve.flaw();
}

}  // namespace tacit
