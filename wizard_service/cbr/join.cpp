#include "wizard_service/cbr/join.h"

#include <algorithm>
#include <map>
#include <set>

#include "wizard_service/cbr/adapt.h"
#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/plan_cdl.h"

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

/// Adds what is not there yet, and says how what is there is called now.
Names add_shared(std::vector<cdl::Statement>& shared, const std::vector<cdl::Statement>& more) {
  Names names;
  for (const cdl::Statement& one : more) {
    cdl::Statement added = one;
    rename(added.body, names);
    const auto same = std::find_if(shared.begin(), shared.end(), [&](const cdl::Statement& there) {
      return there.body == added.body && there.keyword == added.keyword;
    });
    if (same != shared.end()) {
      names[one.name] = same->name;
      continue;
    }
    added.name = fresh_shared(shared);
    names[one.name] = added.name;
    shared.push_back(std::move(added));
  }
  return names;
}

/// Stands for the state that comes next as long as it has no name.
constexpr std::string_view kNext = "?";

bool ends_by_itself(const RobotPlan& part) {
  const auto reached = reachable_from(part, kStart);
  return std::any_of(reached.begin(), reached.end(),
                     [](const PlanState* one) { return is_end(*one); });
}

bool ends_for_all(const PlanState& state) {
  return behaviour_name(state.behaviour) == "TerminateMission";
}

bool ends_for_all(const RobotPlan& part) {
  const auto reached = reachable_from(part, kStart);
  return std::any_of(reached.begin(), reached.end(),
                     [](const PlanState* one) { return ends_for_all(*one); });
}

/// Builds one robot's automaton out of its parts of the pieces.
class Chain {
 public:
  Chain(RobotPlan& robot, const Terrain& terrain, std::size_t place_in_squad)
      : robot_(robot), terrain_(terrain), place_in_squad_(place_in_squad) {
    robot_.states = {{std::string(kStart), "Start", behaviour("Stop"), {to_next("Immediate")}}};
  }

  /// The way to a piece's site and the state that the piece begins after.
  void add_joint(const Piece& piece) {
    if (piece.site.out_of_building) leave_building(piece.number);
    MapPoint last = here_.value_or(terrain_.start());
    for (std::size_t i = 0; i + 1 < piece.site.way.size(); ++i) {
      go(piece.number, last, piece.site.way[i]);
      last = piece.site.way[i];
    }
    deploy(piece, last);
    here_ = piece.site.at;
  }

  /// The robot's part of a piece. By `release` it hears that the piece is over when its part has no
  /// end, or says so when it ends the piece for all; empty: neither.
  void add_part(const RobotPlan& part, const std::string& release) {
    const std::string entry = entry_of(part);
    const std::vector<const PlanState*> reached = reachable_from(part, entry);
    const Names names = names_for(reached, release);
    const bool listens = !release.empty() && !ends_by_itself(part);
    if (const auto first = names.find(entry); first != names.end() && first->second != kNext) {
      lead_to(first->second);
    }
    for (const PlanState* one : reached) {
      if (names.at(one->name) == kNext) continue;
      robot_.states.push_back(is_end(*one) ? farewell(names.at(one->name), release)
                                           : renamed(*one, names));
      if (listens)
        robot_.states.back().rules.insert(robot_.states.back().rules.begin(), hears(release));
    }
  }

  /// After the last piece's part nothing follows.
  void close(bool for_all) {
    PlanState done{
        fresh_name(robot_), "Done", behaviour(for_all ? "TerminateMission" : "Terminate"), {}};
    if (lead_to(done.name)) robot_.states.push_back(std::move(done));
  }

 private:
  static PlanRule to_next(std::string_view trigger, std::vector<Given> parameters = {}) {
    return {behaviour(trigger, std::move(parameters)), std::string(kNext)};
  }

  static PlanRule hears(const std::string& word) {
    return to_next("Notified", {{"notify_message", '"' + word + '"'}});
  }

  /// Says that the piece is over.
  static PlanState farewell(const std::string& name, const std::string& word) {
    return {name,
            "Over",
            behaviour("NotifyRobots", {{"notify_message", '"' + word + '"'}}),
            {to_next("MessageSent")}};
  }

  static PlanState renamed(const PlanState& state, const Names& names) {
    PlanState copy{names.at(state.name), state.label, state.behaviour, {}};
    for (const PlanRule& rule : state.rules) {
      const auto target = names.find(rule.target);
      if (target != names.end()) copy.rules.push_back({rule.trigger, target->second});
    }
    return copy;
  }

  /// Ends of a part are what comes next, but for those in which there is something to say.
  Names names_for(const std::vector<const PlanState*>& states, const std::string& release) const {
    Names names;
    std::size_t number = robot_.states.size();
    for (const PlanState* one : states) {
      if (is_end(*one) && (release.empty() || !ends_for_all(*one))) {
        names[one->name] = kNext;
        continue;
      }
      do {
        names[one->name] = "$AN_" + std::to_string(number++);
      } while (find_state(robot_, names[one->name]) != nullptr);
    }
    return names;
  }

  void leave_building(const std::string& number) {
    append(std::string(kWayLabel) + number, behaviour("LeaveRoom"), to_next("InHallway"));
    if (here_) go(number, *here_, *here_);
  }

  void go(const std::string& number, const MapPoint& from, const MapPoint& to) {
    append(std::string(kWayLabel) + number, behaviour("GoTo", given(from, to)),
           there("AtGoal", to));
  }

  void deploy(const Piece& piece, const MapPoint& from) {
    append(piece.label, behaviour("StartSubMission", given(from, piece.site.at)),
           there("SubMissionReady", piece.site.at));
  }

  /// One that comes behind others stops short of where they may stand.
  [[nodiscard]] PlanRule there(std::string_view trigger, const MapPoint& goal) const {
    const double tolerance = 0.5 + 0.8 * static_cast<double>(place_in_squad_);
    return to_next(trigger, {{"Goal_Tolerance", number_text(tolerance)},
                             {"Goal_Location", place_text(goal.x_m, goal.y_m)}});
  }

  [[nodiscard]] std::vector<Given> given(const MapPoint& from, const MapPoint& to) const {
    const AvoidGains gains =
        usual_gains(terrain_.is_roomy(from, to) ? Environment::Outdoor : Environment::Indoor);
    return {{"Goal_Location", place_text(to.x_m, to.y_m)},
            {"move_to_location_gain", "1"},
            {"wander_gain", "0"},
            {"avoid_obstacle_gain", number_text(gains.gain)},
            {"avoid_obstacle_sphere", number_text(gains.sphere_m)},
            {"avoid_obstacle_safety_margin", number_text(gains.margin_m)}};
  }

  void append(std::string label, cdl::Expression what, PlanRule out) {
    const std::string name = fresh_name(robot_);
    (void)lead_to(name);
    robot_.states.push_back({name, std::move(label), std::move(what), {std::move(out)}});
  }

  /// Names what comes next, now that it is known; false when nothing leads there.
  bool lead_to(const std::string& target) {
    bool led = false;
    for (PlanState& one : robot_.states) {
      for (PlanRule& rule : one.rules) {
        if (rule.target != kNext) continue;
        rule.target = target;
        led = true;
      }
    }
    return led;
  }

  RobotPlan& robot_;
  const Terrain& terrain_;
  std::size_t place_in_squad_;
  std::optional<MapPoint> here_;
};

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

Plan join(const std::vector<Piece>& pieces, const Terrain& terrain, bool alone, Changes& changes) {
  Plan plan;
  std::vector<std::vector<RobotPlan>> parts;
  for (const Piece& piece : pieces) {
    const Names names = add_shared(plan.shared, piece.plan.shared);
    parts.push_back(piece.plan.robots);
    for (RobotPlan& part : parts.back()) rename(part, names);
  }
  for (std::size_t r = 0; r < pieces.front().plan.robots.size(); ++r) {
    RobotPlan robot = pieces.front().plan.robots[r];
    Chain chain(robot, terrain, r);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const bool may_end_mission = alone && p + 1 == pieces.size();
      chain.add_joint(pieces[p]);
      chain.add_part(parts[p][r], release_of(pieces[p], may_end_mission));
    }
    chain.close(alone && ends_for_all(parts.back()[r]));
    plan.robots.push_back(std::move(robot));
  }
  tell_joints(pieces, changes);
  return plan;
}

void add_robots(Plan& plan, const Plan& more) {
  const Names names = add_shared(plan.shared, more.shared);
  for (RobotPlan robot : more.robots) {
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
