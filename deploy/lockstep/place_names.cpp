#include "deploy/lockstep/place_names.h"

#include <algorithm>
#include <vector>

#include "idl/cdl/finding.h"
#include "idl/cdl/parse.h"
#include "idl/cdl/print.h"
#include "idl/cdl/value.h"
#include "idl/types/config_error.h"
#include "idl/types/lowered.h"
#include "idl/types/nearest_word.h"
#include "idl/types/shortest.h"

namespace tacit {
namespace {

cdl::Mission read(const std::string& text, std::string_view name) {
  cdl::Parsed parsed = cdl::parse(text);
  cdl::refuse_errors(std::move(parsed.findings), text, name);
  return std::move(parsed.mission);
}

/// Puts places for names, all the way down.
class Placer {
 public:
  explicit Placer(const MapPlan& plan) : plan_(plan) {
    for (const PlanPoint& point : plan.points) names_.push_back(point.name);
  }

  void visit(cdl::Expression& expression) {
    for (cdl::Item& item : expression.items) {
      if (item.slot && item.slot->name == "Goal_Location" &&
          item.value.kind == cdl::Expression::Kind::Value) {
        place(item.value);
      }
      visit(item.value);
    }
  }
  [[nodiscard]] cdl::Findings& findings() { return findings_; }

 private:
  void place(cdl::Expression& value) {
    const cdl::Value read = cdl::parse_value(value.name);
    const auto* words = std::get_if<cdl::Words>(&read);
    if (words == nullptr || words->words.size() != 1) return;
    const std::string& word = words->words.front();
    const auto found = std::find_if(
        plan_.points.begin(), plan_.points.end(),
        [wanted = lowered(word)](const PlanPoint& point) { return lowered(point.name) == wanted; });
    if (found == plan_.points.end()) {
      findings_.push_back({cdl::Severity::Error, "undefined-place",
                           "no point of the map is called " + word + did_you_mean(word, names_),
                           value.span.begin, 0, 0});
      return;
    }
    value.name = shortest(found->at.x_m - plan_.ground.shift_m.x_m) + ", " +
                 shortest(found->at.y_m - plan_.ground.shift_m.y_m);
  }

  const MapPlan& plan_;
  std::vector<std::string> names_;
  cdl::Findings findings_;
};

/// The list of the team's robots: the innermost of groups in groups.
cdl::Expression* robots_of(cdl::Expression& team) {
  cdl::Expression* group = &team;
  while (group->items.size() == 1 &&
         group->items.front().value.kind == cdl::Expression::Kind::Group) {
    group = &group->items.front().value;
  }
  return group->items.empty() ? nullptr : group;
}

}  // namespace

std::string with_places(const std::string& text, std::string_view name, const MapPlan& plan) {
  cdl::Mission mission = read(text, name);
  Placer placer(plan);
  for (cdl::Statement& statement : mission.statements) placer.visit(statement.body);
  cdl::refuse_errors(std::move(placer.findings()), text, name);
  return cdl::print(mission, text);
}

std::string with_robots(const std::string& text, std::string_view name, std::size_t robots) {
  cdl::Mission mission = read(text, name);
  for (cdl::Statement& statement : mission.statements) {
    if (statement.kind != cdl::Statement::Kind::Configuration) continue;
    cdl::Expression* group = robots_of(statement.body);
    if (group == nullptr) break;
    // A copy, for the vector that it lies in may move.
    const cdl::Item last = group->items.back();
    group->items.resize(robots, last);
    return cdl::print(mission, text);
  }
  throw ConfigError(std::string(name) + ": it names no team to take robots from");
}

}  // namespace tacit
