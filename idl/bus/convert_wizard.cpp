#include "idl/bus/convert_wizard.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "idl/bus/sieve_texts.h"
#include "idl/wire/wizard.h"

namespace tacit {
namespace {

constexpr std::uint8_t kLeftOpen = 2;
constexpr double kAny = std::numeric_limits<double>::max();

enum class Kind : std::uint8_t { Plan, Outcome, Store, State };

template <class Value>
std::uint8_t to_code(const std::optional<Value>& value) {
  return value ? static_cast<std::uint8_t>(*value) : kLeftOpen;
}

template <class Value>
std::optional<Value> sieve_code(Sieve& sieve, std::uint8_t code, std::string_view what) {
  if (!sieve.pass(code <= kLeftOpen, what) || code == kLeftOpen) return std::nullopt;
  return static_cast<Value>(code);
}

void to_wire(const PlacedTask& word, wire::PlacedTask& wire) {
  wire.x_m(word.x_m);
  wire.y_m(word.y_m);
  wire.task(static_cast<std::uint8_t>(word.task));
  wire.localization(to_code(word.localization));
  wire.environment(to_code(word.environment));
  wire.handles_enemy(to_code(word.handles_enemy));
}

PlacedTask sieve_task(Sieve& sieve, const wire::PlacedTask& wire) {
  PlacedTask task;
  task.x_m = sieve.number(wire.x_m(), -kAny, kAny, "a task's place is no number");
  task.y_m = sieve.number(wire.y_m(), -kAny, kAny, "a task's place is no number");
  task.task = sieve.code(wire.task(), Task::SearchAndRescue, "unknown task");
  task.localization =
      sieve_code<Localization>(sieve, wire.localization(), "unknown localization of a task");
  task.environment =
      sieve_code<Environment>(sieve, wire.environment(), "unknown environment of a task");
  task.handles_enemy =
      sieve_code<bool>(sieve, wire.handles_enemy(), "a task's enemy is neither 0, 1 nor 2");
  return task;
}

void to_wire(const CaseFeatures& word, wire::CaseFeatures& wire) {
  wire.task(static_cast<std::uint8_t>(word.task));
  wire.robots(static_cast<std::uint8_t>(std::clamp(word.robots, 0, 255)));
  wire.localization(static_cast<std::uint8_t>(word.localization));
  wire.environment(static_cast<std::uint8_t>(word.environment));
  wire.handles_enemy(word.handles_enemy ? 1 : 0);
}

CaseFeatures sieve_features(Sieve& sieve, const wire::CaseFeatures& wire) {
  CaseFeatures features;
  features.task = sieve.code(wire.task(), Task::SearchAndRescue, "unknown task of a case");
  features.robots =
      sieve.whole<int>(wire.robots(), 1, kMostPlannedRobots, "a case is for 1 to 10 robots");
  features.localization =
      sieve.code(wire.localization(), Localization::UseMaps, "unknown localization of a case");
  features.environment =
      sieve.code(wire.environment(), Environment::Outdoor, "unknown environment of a case");
  features.handles_enemy = sieve.flag(wire.handles_enemy(), "a case's enemy is neither 0 nor 1");
  return features;
}

void to_wire(const AskForPlans& word, wire::WizardRequest& wire) {
  const PlanRequest& request = word.request;
  wire.kind(static_cast<std::uint8_t>(Kind::Plan));
  wire.tasks(cut_list<wire::PlacedTask>(
      request.tasks, kShortList,
      [](const PlacedTask& from, wire::PlacedTask& to) { to_wire(from, to); }));
  wire.robots(request.robots.value_or(0));
  wire.any_robots(request.robots ? 0 : 1);
  wire.enemy(request.enemy ? 1 : 0);
  wire.naive(request.naive ? 1 : 0);
  wire.top(static_cast<std::uint32_t>(
      std::min<std::size_t>(request.top, std::numeric_limits<std::uint32_t>::max())));
  wire.max_velocity_mps(request.max_velocity_mps);
  wire.aggressiveness(request.aggressiveness);
  wire.map_text(word.map);
}

AskForPlans sieve_plan(Sieve& sieve, const wire::WizardRequest& wire) {
  AskForPlans ask;
  PlanRequest& request = ask.request;
  request.tasks =
      sieve_list<PlacedTask>(sieve, wire.tasks(), kShortList, "more than 1000 tasks",
                             [&](const wire::PlacedTask& task) { return sieve_task(sieve, task); });
  if (!sieve.flag(wire.any_robots(), "any robots is neither 0 nor 1")) {
    request.robots = wire.robots();
  }
  request.enemy = sieve.flag(wire.enemy(), "enemy is neither 0 nor 1");
  request.naive = sieve.flag(wire.naive(), "naive is neither 0 nor 1");
  request.top = wire.top();
  request.max_velocity_mps =
      sieve.number(wire.max_velocity_mps(), -kAny, kAny, "max velocity is no number");
  request.aggressiveness =
      sieve.number(wire.aggressiveness(), -kAny, kAny, "aggressiveness is no number");
  ask.map = sieve_text(sieve, wire.map_text(), kLongestPlanText, "a map is longer than 4 MB");
  return ask;
}

void to_wire(const ReportOutcome& word, wire::WizardRequest& wire) {
  wire.kind(static_cast<std::uint8_t>(Kind::Outcome));
  wire.cases(word.cases);
  wire.score(word.score);
  wire.failures(cut_texts(word.failures));
  wire.map_text(cut(word.map, kShortText));
}

ReportOutcome sieve_outcome(Sieve& sieve, const wire::WizardRequest& wire) {
  ReportOutcome report;
  report.cases = sieve_list<CaseId>(sieve, wire.cases(), kShortList, "more than 1000 cases",
                                    [](std::uint64_t id) { return id; });
  report.score = sieve.number(wire.score(), 0.0, 1.0, "an outcome's score is not in 0 to 1");
  report.failures = sieve_texts(sieve, wire.failures(), "too many or too long failures");
  report.map = sieve_text(sieve, wire.map_text(), kShortText, "a map's name is too long");
  return report;
}

void to_wire(const StoreMission& word, wire::WizardRequest& wire) {
  wire.kind(static_cast<std::uint8_t>(Kind::Store));
  wire.mission(word.mission);
  wire.title(cut(word.title, kShortText));
  wire.features(cut_list<wire::CaseFeatures>(
      word.features, kShortList,
      [](const CaseFeatures& from, wire::CaseFeatures& to) { to_wire(from, to); }));
}

StoreMission sieve_mission(Sieve& sieve, const wire::WizardRequest& wire) {
  StoreMission store;
  store.mission =
      sieve_text(sieve, wire.mission(), kLongestPlanText, "a mission is longer than 4 MB");
  store.title = sieve_text(sieve, wire.title(), kShortText, "a mission's title is too long");
  store.features = sieve_list<CaseFeatures>(
      sieve, wire.features(), kShortList, "features of more than 1000 cases",
      [&](const wire::CaseFeatures& features) { return sieve_features(sieve, features); });
  return store;
}

void to_wire(const AskForState&, wire::WizardRequest& wire) {
  wire.kind(static_cast<std::uint8_t>(Kind::State));
}

}  // namespace

void to_wire(const WizardRequest& word, wire::WizardRequest& wire) {
  wire = {};
  wire.client(word.client);
  wire.number(word.number);
  std::visit([&](const auto& what) { to_wire(what, wire); }, word.what);
}

Flaw from_wire(const wire::WizardRequest& wire, WizardRequest& word) {
  Sieve sieve;
  word.client = wire.client();
  word.number = wire.number();
  sieve.pass(word.client != 0, "client is 0");
  sieve.pass(word.number != 0, "number is 0");
  switch (sieve.code(wire.kind(), Kind::State, "unknown kind of request")) {
    case Kind::Plan:
      word.what = sieve_plan(sieve, wire);
      break;
    case Kind::Outcome:
      word.what = sieve_outcome(sieve, wire);
      break;
    case Kind::Store:
      word.what = sieve_mission(sieve, wire);
      break;
    case Kind::State:
      word.what = AskForState{};
      break;
  }
  return sieve.flaw();
}

}  // namespace tacit
