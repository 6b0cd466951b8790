#include "wizard_service/cbr/join.h"

#include <algorithm>
#include <map>
#include <utility>

#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/chain.h"
#include "wizard_service/cbr/plan_cdl.h"
#include "wizard_service/cbr/watch.h"

namespace tacit::cbr {
namespace {

using Names = std::map<std::string, std::string>;

/// Renames what an expression refers to.
void rename(cdl::Expression& expression, const Names& names) {
  if (expression.kind == cdl::Expression::Kind::Reference) {
    const auto found = names.find(expression.name);
    if (found != names.end()) expression.name = found->second;
  }
  for (cdl::Item& item : expression.items) rename(item.value, names);
}

void rename(RobotPlan& robot, const Names& names) {
  for (PlanState& state : robot.states) {
    rename(state.behaviour, names);
    for (PlanRule& rule : state.rules) rename(rule.trigger, names);
  }
}

bool takes(const std::vector<cdl::Statement>& shared, const std::string& name) {
  return std::any_of(shared.begin(), shared.end(),
                     [&](const cdl::Statement& one) { return one.name == name; });
}

std::string fresh_shared(const std::vector<cdl::Statement>& shared) {
  for (std::size_t number = 1000 + shared.size();; ++number) {
    std::string name = "$AN_" + std::to_string(number);
    if (!takes(shared, name)) return name;
  }
}

/// The robot without what it does.
RobotPlan as_a_body(const RobotPlan& robot) {
  return {robot.name,         robot.type,    {}, robot.max_mps, robot.base_mps,
          robot.cautious_mps, robot.cautious};
}

/// Adds what is not there yet, and says how what is there is called now.
Names add_shared(std::vector<cdl::Statement>& shared, std::vector<cdl::Statement> more) {
  Names names;
  for (cdl::Statement& added : more) {
    const std::string before = added.name;
    rename(added.body, names);
    const auto same = std::find_if(shared.begin(), shared.end(), [&](const cdl::Statement& there) {
      return there.body == added.body && there.keyword == added.keyword;
    });
    if (same != shared.end()) {
      names[before] = same->name;
      continue;
    }
    added.name = fresh_shared(shared);
    names[before] = added.name;
    shared.push_back(std::move(added));
  }
  return names;
}

/// The word by which a piece is over for those who cannot tell; empty when none is needed.
std::string release_of(const Piece& piece, bool may_end_mission) {
  const auto& parts = piece.plan.robots;
  const bool endless = std::any_of(parts.begin(), parts.end(),
                                   [](const RobotPlan& one) { return !ends_by_itself(one); });
  const bool for_all = std::any_of(parts.begin(), parts.end(),
                                   [](const RobotPlan& one) { return ends_for_all(one); });
  return endless && for_all && !may_end_mission ? release_word(piece.number) : "";
}

void tell_joints(const std::vector<Piece>& pieces, Changes& changes) {
  for (const Piece& piece : pieces) {
    changes.adapt("deploy", piece.label + " begins when its robots are at its place.", "",
                  "StartSubMission at (" + place_text(piece.site.at.x_m, piece.site.at.y_m) + ')');
  }
}

/// By piece, what robots say of enemies on the way to it: what they say in the first piece from it
/// on in which they say anything.
std::vector<std::string> warnings_on_the_way(const std::vector<Piece>& pieces) {
  std::vector<std::string> warnings(pieces.size());
  std::string next;
  for (std::size_t i = pieces.size(); i-- > 0;) {
    const std::string own = warning_of(pieces[i].plan);
    if (!own.empty()) next = own;
    warnings[i] = next;
  }
  return warnings;
}

void tell_watch(const std::vector<Piece>& pieces, const std::vector<std::string>& warnings,
                Changes& changes) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (warnings[i].empty()) continue;
    changes.adapt("watch",
                  "On the way to " + pieces[i].label +
                      " robots look out for enemies already, and warn each other.",
                  "", warnings[i]);
  }
}

constexpr std::string_view kReleaseBegin = "Task ";
constexpr std::string_view kReleaseEnd = " is over.";

}  // namespace

std::string release_word(std::string_view number) {
  return std::string(kReleaseBegin) + std::string(number) + std::string(kReleaseEnd);
}

bool is_release_word(std::string_view word) {
  return word.starts_with(kReleaseBegin) && word.ends_with(kReleaseEnd) &&
         word.size() > kReleaseBegin.size() + kReleaseEnd.size();
}

Plan join(std::vector<Piece> pieces, const Terrain& terrain, bool alone, Changes& changes) {
  Plan plan;
  const std::vector<std::string> warnings = warnings_on_the_way(pieces);
  std::vector<std::string> releases;
  for (Piece& piece : pieces) {
    const Names names = add_shared(plan.shared, std::move(piece.plan.shared));
    for (RobotPlan& part : piece.plan.robots) rename(part, names);
    releases.push_back(release_of(piece, alone && releases.size() + 1 == pieces.size()));
  }
  for (std::size_t r = 0; r < pieces.front().plan.robots.size(); ++r) {
    RobotPlan robot = as_a_body(pieces.front().plan.robots[r]);
    Chain chain(robot, terrain, r);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      chain.add_joint(pieces[p], warnings[p]);
      chain.add_part(pieces[p].plan.robots[r], releases[p]);
    }
    chain.close(alone && ends_for_all(pieces.back().plan.robots[r]));
    plan.robots.push_back(std::move(robot));
  }
  tell_joints(pieces, changes);
  tell_watch(pieces, warnings, changes);
  return plan;
}

void add_robots(Plan& plan, Plan more) {
  const Names names = add_shared(plan.shared, std::move(more.shared));
  for (RobotPlan& robot : more.robots) {
    rename(robot, names);
    const auto same =
        std::count_if(plan.robots.begin(), plan.robots.end(), [&](const RobotPlan& one) {
          return one.name == robot.name || one.name.starts_with(robot.name + '_');
        });
    if (same > 0) robot.name += '_' + std::to_string(same + 1);
    plan.robots.push_back(std::move(robot));
  }
}

}  // namespace tacit::cbr
