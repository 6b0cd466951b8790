#include "wizard_service/cbr/store.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "idl/types/config_error.h"
#include "wizard_service/cbr/cut.h"

namespace tacit::cbr {
namespace {

/// 2 of "BiohazardTask 2".
std::optional<std::size_t> number_in(const std::string& label) {
  const std::size_t blank = label.rfind(' ');
  if (blank == std::string::npos) return std::nullopt;
  std::size_t number = 0;
  const char* const end = label.data() + label.size();
  const auto [stop, error] = std::from_chars(label.data() + blank + 1, end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// Whether every sub-mission says which one it is, and no robot says so twice.
bool are_numbered(const std::vector<std::vector<Cut>>& robots) {
  return std::all_of(robots.begin(), robots.end(), [](const std::vector<Cut>& cuts) {
    std::set<std::size_t> numbers;
    return std::all_of(cuts.begin(), cuts.end(), [&](const Cut& cut) {
      const std::optional<std::size_t> number = number_in(cut.label);
      return number && numbers.insert(*number).second;
    });
  });
}

/// Each sub-mission's robots, in order.
std::map<std::size_t, Plan> put_together(const std::vector<std::vector<Cut>>& robots) {
  const bool numbered = are_numbered(robots);
  std::map<std::size_t, Plan> pieces;
  for (const std::vector<Cut>& cuts : robots) {
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      pieces[numbered ? *number_in(cuts[i].label) : i].robots.push_back(cuts[i].part);
    }
  }
  return pieces;
}

/// Keeps those of `shared` that the plan's states refer to, directly or by way of others.
class SharedKeeper {
 public:
  explicit SharedKeeper(const std::vector<cdl::Statement>& shared) : shared_(shared) {
    for (const cdl::Statement& one : shared) bodies_.emplace(one.name, &one.body);
  }

  [[nodiscard]] std::vector<cdl::Statement> kept_for(const Plan& plan) const {
    std::set<std::string> wanted;
    for (const RobotPlan& robot : plan.robots) {
      for (const PlanState& state : robot.states) {
        want(state.behaviour, wanted);
        for (const PlanRule& rule : state.rules) want(rule.trigger, wanted);
      }
    }
    std::vector<cdl::Statement> kept;
    for (const cdl::Statement& one : shared_) {
      if (wanted.contains(one.name)) kept.push_back(one);
    }
    return kept;
  }

 private:
  void want(const cdl::Expression& expression, std::set<std::string>& wanted) const {
    std::vector<const cdl::Expression*> open{&expression};
    while (!open.empty()) {
      const cdl::Expression* one = open.back();
      open.pop_back();
      for (const cdl::Item& item : one->items) open.push_back(&item.value);
      if (one->kind != cdl::Expression::Kind::Reference) continue;
      const auto body = bodies_.find(one->name);
      if (body != bodies_.end() && wanted.insert(one->name).second) open.push_back(body->second);
    }
  }

  const std::vector<cdl::Statement>& shared_;
  std::map<std::string, const cdl::Expression*, std::less<>> bodies_;
};

Case made(Plan plan, const CaseFeatures& features, std::string title) {
  Case piece;
  piece.title = std::move(title);
  piece.origin = "stored";
  piece.features = features;
  piece.features.robots = std::clamp(static_cast<int>(plan.robots.size()), 1, kMostPlannedRobots);
  piece.plan = std::move(plan);
  return piece;
}

}  // namespace

std::vector<Case> pieces_of(const Plan& plan, const std::vector<CaseFeatures>& features,
                            std::string_view title) {
  if (features.empty()) {
    throw ConfigError("found no features of \"" + std::string(title) +
                      "\", wanted those of at least one sub-mission");
  }
  std::vector<std::vector<Cut>> robots;
  for (const RobotPlan& robot : plan.robots) robots.push_back(cuts_of(plan, robot));
  std::map<std::size_t, Plan> parts = put_together(robots);
  if (parts.empty()) return {made(plan, features.front(), std::string(title))};
  const SharedKeeper keeper(plan.shared);
  std::vector<Case> pieces;
  for (auto& [key, part] : parts) {
    part.shared = keeper.kept_for(part);
    const std::size_t number = pieces.size() + 1;
    pieces.push_back(
        made(std::move(part), features[std::min(number, features.size()) - 1],
             std::string(title) + (parts.size() > 1 ? ", part " + std::to_string(number) : "")));
  }
  return pieces;
}

}  // namespace tacit::cbr
