#include "console/debrief/cover.h"

#include <algorithm>
#include <utility>

namespace tacit {
namespace {

constexpr double kMostUncovered_s = 5.0;
constexpr const char* kNoRoom = "Robot 1 surveyed no room.";

}  // namespace

Cover::Cover(const MapPlan& plan, const TimeScale& scale)
    : scale_(scale), most_uncovered_(scale.ticks(kMostUncovered_s)) {
  for (const PlanRoom& room : plan.rooms) {
    names_.push_back(room.name);
  }
}

void Cover::add(const Event& event, const TeamWatch& team) {
  if (uncovered_since_ && here_ != 0 && event.tick > *uncovered_since_) {
    surveys_[here_].uncovered += event.tick - *uncovered_since_;
  }
  if (const auto* entered = std::get_if<SiteEntered>(&event.what)) {
    if (entered->robot == kFirstRobot) move(*entered, event, team);
  } else if (const auto* said = std::get_if<Signalled>(&event.what)) {
    const bool outside = team.where(kFirstRobot).site != Site::Room;
    asked_ = asked_ || (outside && said->robot == kFirstRobot && said->word.text() == kCoverMe);
  } else if (const auto* tested = std::get_if<ObjectTested>(&event.what)) {
    if (tested->robot == kFirstRobot && refuge_) survey(refuge_room_, {*refuge_, true, 0});
  } else if (std::holds_alternative<MissionOver>(event.what)) {
    here_ = 0;
  }
  uncovered_since_ = is_uncovered(team) ? std::optional(event.tick) : std::nullopt;
}

void Cover::survey(std::uint32_t room, const Survey& survey) {
  refuge_.reset();
  here_ = room;
  surveys_.try_emplace(room, survey);
}

void Cover::move(const SiteEntered& entered, const Event& event, const TeamWatch& team) {
  here_ = 0;
  refuge_.reset();
  if (entered.site != Site::Room) return;
  const bool asked = std::exchange(asked_, false);
  const Deed entry{entered.robot, event.tick};
  if (!team.alarm()) {
    survey(entered.number, {entry, asked, 0});
  } else if (asked) {
    refuge_ = entry;
    refuge_room_ = entered.number;
  }
}

bool Cover::is_uncovered(const TeamWatch& team) const {
  if (here_ == 0 || team.alarm()) return false;
  for (std::size_t i = 2; i <= team.team(); ++i) {
    const Whereabouts& other = team.where({static_cast<std::uint16_t>(i)});
    if (other.site == Site::Hallway || (other.site == Site::Room && other.number != here_)) {
      return false;
    }
  }
  return true;
}

std::string Cover::called(std::uint32_t room) const {
  const bool named = room >= 1 && room <= names_.size() && !names_[room - 1].empty();
  return named ? names_[room - 1] : "room " + std::to_string(room);
}

std::string Cover::entry_told(std::uint32_t room) const {
  return scale_.told(surveys_.at(room).entry, "entered " + called(room));
}

SubTask Cover::asking() const {
  SubTask task{"Ask for cover before each survey", false, kNoRoom};
  const auto unasked = std::find_if(surveys_.begin(), surveys_.end(),
                                    [](const auto& each) { return !each.second.asked; });
  if (unasked != surveys_.end()) {
    task.evidence = entry_told(unasked->first) + " without \"Cover me.\" before.";
  } else if (!surveys_.empty()) {
    const auto first = std::min_element(
        surveys_.begin(), surveys_.end(),
        [](const auto& a, const auto& b) { return a.second.entry.tick < b.second.entry.tick; });
    task.done = true;
    task.evidence = "\"Cover me.\" came before each of " + std::to_string(surveys_.size()) +
                    " surveys; the first: " + entry_told(first->first) + '.';
  }
  return task;
}

SubTask Cover::covering() const {
  SubTask task{"Cover each survey", false, kNoRoom};
  const auto worst = std::max_element(
      surveys_.begin(), surveys_.end(),
      [](const auto& a, const auto& b) { return a.second.uncovered < b.second.uncovered; });
  if (worst == surveys_.end()) return task;
  task.done = worst->second.uncovered <= most_uncovered_;
  task.evidence = entry_told(worst->first) + " and was without cover there for " +
                  scale_.seconds(worst->second.uncovered) + (task.done ? " at most." : ".");
  return task;
}

void Cover::append_to(Checklist& list) const {
  list.tasks.push_back(asking());
  list.tasks.push_back(covering());
}

}  // namespace tacit
