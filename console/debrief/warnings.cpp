#include "console/debrief/warnings.h"

#include <algorithm>
#include <string>

namespace tacit {
namespace {

constexpr double kNear_s = 10.0;
constexpr double kSame_s = 30.0;
constexpr double kHide_s = 40.0;

template <class... Kinds>
bool is_any(const Happening& what) {
  return (std::holds_alternative<Kinds>(what) || ...);
}

/// Whether the first robot does something.
bool is_of_first_robot(const Happening& what) {
  return std::visit(
      [](const auto& each) {
        if constexpr (requires { each.robot; }) {
          return each.robot == kFirstRobot;
        } else {
          return false;
        }
      },
      what);
}

}  // namespace

Warnings::Warnings(std::size_t team, const TimeScale& scale)
    : scale_(scale),
      near_(scale.ticks(kNear_s)),
      same_(scale.ticks(kSame_s)),
      hide_(scale.ticks(kHide_s)),
      fleeing_(team) {}

void Warnings::add(const Event& event, const TeamWatch& team) {
  if (over_) return;
  now_ = std::max(now_, event.tick);
  go_on(event);
  if (const auto* exposed = std::get_if<RobotExposed>(&event.what)) {
    expose(*exposed, event, team);
  } else if (const auto* said = std::get_if<Signalled>(&event.what)) {
    hear(*said, event, team);
  } else if (const auto* entered = std::get_if<SiteEntered>(&event.what)) {
    if (team.in_team(entered->robot)) enter(*entered);
  } else if (std::holds_alternative<MissionOver>(event.what)) {
    over_ = true;
  }
}

void Warnings::expose(const RobotExposed& exposed, const Event& event, const TeamWatch& team) {
  if (!exposed.exposed || !team.in_team(exposed.robot) || team.in_team(exposed.to)) return;
  if (exposures_.empty() || now_ - exposures_.back().last > same_) {
    exposures_.push_back({{exposed.robot, event.tick}, now_, false});
  }
  Exposure& exposure = exposures_.back();
  exposure.last = now_;
  exposure.warned = exposure.warned || team.alarm() || (warned_ && now_ - warned_->tick <= near_);
}

void Warnings::hear(const Signalled& said, const Event& event, const TeamWatch& team) {
  if (team.is_call(said, kEnemyFound)) {
    warned_ = Deed{said.robot, now_};
    warn(team);
  } else if (team.is_call(said, kHallwayClear)) {
    clear_ = Deed{said.robot, event.tick};
    went_on_.reset();
  }
}

void Warnings::warn(const TeamWatch& team) {
  if (!exposures_.empty() && now_ - exposures_.back().last <= near_) {
    exposures_.back().warned = true;
  }
  for (std::size_t i = 0; i < fleeing_.size(); ++i) {
    const RobotId robot{static_cast<std::uint16_t>(i + 1)};
    if (!fleeing_[i] && team.where(robot).site != Site::Room) fleeing_[i] = now_;
  }
}

void Warnings::enter(const SiteEntered& entered) {
  std::optional<Tick>& since = fleeing_[entered.robot.value - 1U];
  if (entered.site != Site::Room || !since) return;
  if (is_late(*since, now_) && !late_) late_ = Deed{entered.robot, *since};
  since.reset();
}

void Warnings::go_on(const Event& event) {
  const auto* over = std::get_if<MissionOver>(&event.what);
  const bool accomplished = over != nullptr && over->verdict == Verdict::Accomplished;
  const bool busy = is_any<SiteEntered, ObjectTested, DoorwayMarked, Signalled>(event.what) &&
                    is_of_first_robot(event.what);
  if (clear_ && !went_on_ && (accomplished || busy)) went_on_ = event.tick;
}

std::optional<Deed> Warnings::first_late() const {
  if (late_) return late_;
  for (std::size_t i = 0; i < fleeing_.size(); ++i) {
    if (fleeing_[i] && is_late(*fleeing_[i], now_)) {
      return Deed{{static_cast<std::uint16_t>(i + 1)}, *fleeing_[i]};
    }
  }
  return std::nullopt;
}

SubTask Warnings::warning() const {
  const auto missed = std::find_if(exposures_.begin(), exposures_.end(),
                                   [](const Exposure& exposure) { return !exposure.warned; });
  const bool done = missed == exposures_.end();
  const Deed& told = (done ? exposures_.front() : *missed).first;
  return {
      "Warn of each enemy", done,
      scale_.told(told, "was seen by an enemy") +
          (done ? ", the first of " + std::to_string(exposures_.size()) + " times with a warning."
                : " without \"Enemy found.\" at that time.")};
}

SubTask Warnings::hiding() const {
  SubTask task{"Hide after each warning", false, "Nobody said \"Enemy found.\"."};
  if (!warned_) return task;
  const std::optional<Deed> late = first_late();
  task.done = !late;
  task.evidence =
      late ? "Robot " + std::to_string(late->robot.value) + " was not in a room " +
                 scale_.seconds(hide_) + " after the warning " + scale_.at(late->tick) + '.'
           : scale_.told(*warned_, "warned") + " for the last time, and nobody was late in hiding.";
  return task;
}

SubTask Warnings::going_on() const {
  SubTask task{"Go on when the hallway is clear", false, "Nobody said \"Hallway clear.\"."};
  if (!clear_) return task;
  task.done = went_on_.has_value();
  task.evidence = scale_.told(*clear_, "said \"Hallway clear.\"") +
                  (went_on_ ? ", and robot 1 went on " + scale_.at(*went_on_) + '.'
                            : ", but robot 1 did nothing after that.");
  return task;
}

void Warnings::append_to(Checklist& list) const {
  if (exposures_.empty()) return;
  list.tasks.push_back(warning());
  list.tasks.push_back(hiding());
  list.tasks.push_back(going_on());
}

}  // namespace tacit
