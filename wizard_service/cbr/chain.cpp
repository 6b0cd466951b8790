#include "wizard_service/cbr/chain.h"

#include <utility>

#include "wizard_service/cbr/adapt.h"
#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/watch.h"

namespace tacit::cbr {
namespace {

/// Stand for the state that comes next as long as it has no name: for a robot that goes its way in
/// peace, and for one that has been warned.
constexpr std::string_view kNext = "?";
constexpr std::string_view kNextWarned = "?!";

PlanRule to_next(std::string_view trigger, std::vector<Given> parameters = {}) {
  return {behaviour(trigger, std::move(parameters)), std::string(kNext)};
}

PlanRule hears(const std::string& word) {
  return to_next("Notified", {{"notify_message", '"' + word + '"'}});
}

/// Says that the piece is over.
PlanState farewell(const std::string& name, const std::string& word) {
  return {name,
          "Over",
          behaviour("NotifyRobots", {{"notify_message", '"' + word + '"'}}),
          {to_next("MessageSent")}};
}

PlanState renamed(const PlanState& state, const std::map<std::string, std::string>& names) {
  PlanState copy{names.at(state.name), state.label, state.behaviour, {}};
  for (const PlanRule& rule : state.rules) {
    const auto target = names.find(rule.target);
    if (target != names.end()) copy.rules.push_back({rule.trigger, target->second});
  }
  return copy;
}

}  // namespace

Chain::Chain(RobotPlan& robot, const Terrain& terrain, std::size_t place_in_squad)
    : robot_(robot), terrain_(terrain), place_in_squad_(place_in_squad) {
  robot_.states = {{std::string(kStart), "Start", behaviour("Stop"), {to_next("Immediate")}}};
}

void Chain::add_joint(const Piece& piece, const std::string& warning) {
  number_ = piece.number;
  warning_ = warning;
  if (piece.site.out_of_building) leave_building(piece.number);
  MapPoint last = here_.value_or(terrain_.start());
  for (std::size_t i = 0; i + 1 < piece.site.way.size(); ++i) {
    go(piece.number, last, piece.site.way[i]);
    last = piece.site.way[i];
  }
  deploy(piece, last);
  here_ = piece.site.at;
}

void Chain::add_part(const RobotPlan& part, const std::string& release) {
  const std::string entry = entry_of(part);
  const std::vector<const PlanState*> reached = reachable_from(part, entry);
  const Names names = names_for(reached, release);
  const bool listens = !release.empty() && !ends_by_itself(part);
  if (const auto first = names.find(entry); first != names.end() && first->second != kNext) {
    lead_to(kNext, first->second);
    lead_to(kNextWarned, names.at(warned_entry_of(part)));
  }
  for (const PlanState* one : reached) {
    if (names.at(one->name) == kNext) continue;
    robot_.states.push_back(is_end(*one) ? farewell(names.at(one->name), release)
                                         : renamed(*one, names));
    if (listens)
      robot_.states.back().rules.insert(robot_.states.back().rules.begin(), hears(release));
  }
}

void Chain::close(bool for_all) {
  PlanState done{
      fresh_name(robot_), "Done", behaviour(for_all ? "TerminateMission" : "Terminate"), {}};
  const bool led = lead_to(kNext, done.name);
  if (lead_to(kNextWarned, done.name) || led) robot_.states.push_back(std::move(done));
}

/// Ends of a part are what comes next, but for those in which there is something to say.
Chain::Names Chain::names_for(const std::vector<const PlanState*>& states,
                              const std::string& release) const {
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

void Chain::leave_building(const std::string& number) {
  append(std::string(kWayLabel) + number, behaviour("LeaveRoom"), to_next("InHallway"));
  if (here_) go(number, *here_, *here_);
}

void Chain::go(const std::string& number, const MapPoint& from, const MapPoint& to) {
  append(std::string(kWayLabel) + number, behaviour("GoTo", given(from, to)), there("AtGoal", to));
}

void Chain::deploy(const Piece& piece, const MapPoint& from) {
  append(piece.label, behaviour("StartSubMission", given(from, piece.site.at)),
         there("SubMissionReady", piece.site.at));
}

/// One that comes behind others stops short of where they may stand.
PlanRule Chain::there(std::string_view trigger, const MapPoint& goal) const {
  const double tolerance = 0.5 + kSpacing * static_cast<double>(place_in_squad_);
  return to_next(trigger, {{"Goal_Tolerance", number_text(tolerance)},
                           {"Goal_Location", place_text(goal.x_m, goal.y_m)}});
}

std::vector<Given> Chain::given(const MapPoint& from, const MapPoint& to) const {
  const AvoidGains gains =
      usual_gains(terrain_.is_roomy(from, to) ? Environment::Outdoor : Environment::Indoor);
  return {{"Goal_Location", place_text(to.x_m, to.y_m)},
          {"move_to_location_gain", "1"},
          {"wander_gain", "0"},
          {"avoid_obstacle_gain", number_text(gains.gain)},
          {"avoid_obstacle_sphere", number_text(gains.sphere_m)},
          {"avoid_obstacle_safety_margin", number_text(gains.margin_m)}};
}

void Chain::append(std::string label, cdl::Expression what, PlanRule out) {
  const std::string name = fresh_name(robot_);
  lead_to(kNext, name);
  PlanState warned{"", std::string(kWayLabel) + number_ + ", warned", what, {out}};
  robot_.states.push_back({name, std::move(label), std::move(what), {std::move(out)}});
  if (warning_.empty()) {
    lead_to(kNextWarned, name);
  } else {
    append_warned(name, std::move(warned));
  }
}

/// The twin of the state called `quiet` for a robot that has been warned, and what leads there.
void Chain::append_warned(const std::string& quiet, PlanState warned) {
  warned.name = fresh_name(robot_);
  warned.rules.front().target = kNextWarned;
  lead_to(kNextWarned, warned.name);
  const std::string twin = warned.name;
  robot_.states.push_back(std::move(warned));
  const std::string says = fresh_name(robot_);
  robot_.states.push_back({says,
                           std::string(kWayLabel) + number_ + ", enemy found",
                           behaviour("NotifyRobots", {{"notify_message", warning_}}),
                           {{behaviour("MessageSent"), twin}}});
  std::vector<PlanRule>& rules = find_state(robot_, quiet)->rules;
  rules.insert(rules.begin(),
               {{behaviour("Notified", {{"notify_message", warning_}}), twin},
                {behaviour("Detect", {{"Objects", "Enemies"}, {"max_sensor_range", "20"}}), says}});
}

/// Names what comes next, now that it is known; false when nothing leads there.
bool Chain::lead_to(std::string_view placeholder, const std::string& target) {
  bool led = false;
  for (PlanState& one : robot_.states) {
    for (PlanRule& rule : one.rules) {
      if (rule.target != placeholder) continue;
      rule.target = target;
      led = true;
    }
  }
  return led;
}

}  // namespace tacit::cbr
