#include "deploy/tacit/plan_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "wizard_service/cbr/features.h"

namespace tacit {
namespace {

constexpr int kStars = 5;

std::string counted(std::size_t count, const std::string& one, const std::string& more) {
  return std::to_string(count) + ' ' + (count == 1 ? one : more);
}

std::string with_one_digit(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string headline(const PlanRequest& request, const PlanAnswer& answer) {
  std::string text = counted(answer.plans.size(), "plan", "plans") + " for " +
                     counted(request.tasks.size(), "task", "tasks");
  if (request.robots) {
    text += ", " + counted(static_cast<std::size_t>(*request.robots), "robot", "robots");
  }
  return text + (request.enemy ? ", an enemy expected" : "");
}

std::size_t count_changes(const OfferedPlan& plan, PlanChange::Step step, bool mended) {
  return static_cast<std::size_t>(std::count_if(
      plan.changes.begin(), plan.changes.end(),
      [&](const PlanChange& change) { return change.step == step && change.mended == mended; }));
}

std::size_t warnings(const OfferedPlan& plan) {
  return count_changes(plan, PlanChange::Step::Adapt, false) +
         count_changes(plan, PlanChange::Step::Criticize, false);
}

/// Lines after the first are moved in by `indent`.
std::string indented(const std::string& text, const std::string& indent) {
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '\n') out += indent;
  }
  return out;
}

std::string feature_text(const FeatureMatch& match) {
  if (match.wanted.empty()) return match.feature + ' ' + match.found + " (left open)";
  if (match.matches) return match.feature + ' ' + match.found;
  return match.feature + ' ' + match.found + " (wanted " + match.wanted + ')';
}

std::string case_text(const PlanRequest& request, const UsedCase& used, bool explain) {
  const std::string kind = used.task < request.tasks.size()
                               ? std::string(cbr::word(request.tasks[used.task].task))
                               : std::string("task");
  std::string text = "     task " + std::to_string(used.task + 1) + ", " + kind + ": case " +
                     std::to_string(used.id) + ", " + used.title;
  if (!used.record.empty()) text += " (" + used.record + ')';
  text += '\n';
  if (!explain) return text;
  for (const FeatureMatch& match : used.features) {
    text += "         " + std::string(match.matches ? "✓ " : "✗ ") + feature_text(match) + '\n';
  }
  return text;
}

std::string change_text(const PlanChange& change) {
  const bool adapts = change.step == PlanChange::Step::Adapt;
  std::string text = "     " + std::string(change.mended ? (adapts ? "→ " : "! ") : "⚠ ") +
                     change.rule + ": " + indented(change.why, "         ") + '\n';
  if (!change.before.empty()) {
    text += "         before: " + indented(change.before, "                 ") + '\n';
  }
  if (!change.after.empty()) {
    text += "         after:  " + indented(change.after, "                 ") + '\n';
  }
  return text;
}

std::string plan_text(const PlanRequest& request, const OfferedPlan& plan, std::size_t number,
                      bool explain) {
  std::string text = '\n' + std::to_string(number) + ".  " + stars_text(plan.stars) + "  " +
                     plan.arrangement + '\n';
  for (const UsedCase& used : plan.cases) text += case_text(request, used, explain);
  if (explain) {
    for (const PlanChange& change : plan.changes) text += change_text(change);
    return text;
  }
  const std::size_t mended = count_changes(plan, PlanChange::Step::Criticize, true);
  text += "     " +
          counted(count_changes(plan, PlanChange::Step::Adapt, true), "adaptation", "adaptations") +
          ", " + counted(mended, "weakness", "weaknesses") + " mended";
  if (const std::size_t left = warnings(plan); left > 0) {
    text += ", " + counted(left, "warning", "warnings") + ':';
    for (const PlanChange& change : plan.changes) {
      if (!change.mended) text += "\n       ⚠ " + indented(change.why, "         ");
    }
  }
  return text + '\n';
}

}  // namespace

std::string stars_text(double stars) {
  const int full = std::clamp(static_cast<int>(std::lround(stars)), 0, kStars);
  std::string text;
  for (int i = 0; i < kStars; ++i) text += i < full ? "★" : "☆";
  return text + ' ' + with_one_digit(stars);
}

std::string answer_text(const PlanRequest& request, const PlanAnswer& answer, bool explain) {
  std::string text = headline(request, answer) + '\n';
  for (std::size_t i = 0; i < answer.plans.size(); ++i) {
    text += plan_text(request, answer.plans[i], i + 1, explain);
  }
  for (const std::string& note : answer.notes) text += '\n' + note + '\n';
  text.pop_back();
  return text;
}

}  // namespace tacit
