#include "console/debrief/search.h"

#include <algorithm>

#include "console/debrief/open_rooms.h"
#include "idl/overlay/tokens.h"

namespace tacit {
namespace {

std::string called(const PlanRoom& room, std::size_t number) {
  return room.name.empty() ? "room " + std::to_string(number) : room.name;
}

}  // namespace

Search::Search(const MapPlan& plan, Doors doors) : has_hallway_(!plan.halls.empty()) {
  const std::vector<bool> open = open_rooms(plan, doors);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    rooms_.push_back({called(plan.rooms[i], i + 1), open[i], false, std::nullopt});
  }
  std::vector<MapPoint> places;
  std::uint32_t number = 0;
  for (const MapObject& object : plan.objects) {
    ++number;
    if (capitals(object.colour) == "BROWN") {
      suspects_[number].real = object.mobility == Mobility::Movable;
      places.push_back(object.centre);
    }
  }
  const std::vector<std::uint32_t> rooms = rooms_at(plan, places);
  auto room = rooms.begin();
  for (auto& [object, suspect] : suspects_) {
    suspect.room = *room++;
  }
}

void Search::add(const Event& event, const TeamWatch& team) {
  if (const auto* entered = std::get_if<SiteEntered>(&event.what)) {
    if (team.in_team(entered->robot)) enter(*entered, event, team);
  } else if (const auto* tested = std::get_if<ObjectTested>(&event.what)) {
    if (team.in_team(tested->robot)) test(*tested, event);
  } else if (const auto* alerted = std::get_if<Alerted>(&event.what)) {
    if (team.in_team(alerted->robot)) alert(*alerted, event);
  }
}

void Search::enter(const SiteEntered& entered, const Event& event, const TeamWatch& team) {
  const Deed deed{entered.robot, event.tick};
  if (entered.site == Site::Hallway && !in_hallway_) {
    in_hallway_ = deed;
  }
  if (entered.site == Site::Room && entered.number >= 1 && entered.number <= rooms_.size()) {
    Room& room = rooms_[entered.number - 1];
    if (!room.entered) room.entered = deed;
    room.looked_at = room.looked_at || !team.alarm();
  }
}

void Search::test(const ObjectTested& tested, const Event& event) {
  const auto found = suspects_.find(tested.object.value);
  if (found == suspects_.end()) return;
  Suspect& suspect = found->second;
  ++suspect.tests;
  suspect.tested = {tested.robot, event.tick};
  suspect.finding = tested.finding;
  if (suspect.room != 0) {
    rooms_[suspect.room - 1].looked_at = true;
  }
  if (suspect.real && tested.finding == Finding::Dangerous && !found_) {
    found_ = suspect.tested;
    found_in_ = suspect.room;
  }
}

void Search::alert(const Alerted& alerted, const Event& event) {
  std::optional<Deed>& first = found_ ? alerted_ : false_alarm_;
  if (!first) first = Deed{alerted.robot, event.tick};
}

bool Search::has_real() const {
  return std::any_of(suspects_.begin(), suspects_.end(),
                     [](const auto& each) { return each.second.real; });
}

bool Search::is_wanted(const Room& room) const {
  const bool of_a_search = has_hallway_ || !suspects_.empty();
  return room.open && of_a_search && (!alerted_ || room.looked_at);
}

bool Search::is_wanted(const Suspect& suspect) const {
  if (suspect.tests > 0) return true;
  if (suspect.room == 0) return !alerted_;
  const Room& room = rooms_[suspect.room - 1];
  return alerted_ ? room.looked_at && suspect.room != found_in_ : room.entered.has_value();
}

void Search::append_to(Checklist& list, const TimeScale& scale) const {
  if (has_hallway_) {
    list.tasks.push_back({"Enter the hallway", in_hallway_.has_value(),
                          in_hallway_ ? scale.told(*in_hallway_, "was in it") + '.'
                                      : "No robot of the team was in it."});
  }
  for (const Room& room : rooms_) {
    if (is_wanted(room)) list.tasks.push_back(task(room, scale));
  }
  for (const auto& [object, suspect] : suspects_) {
    if (is_wanted(suspect)) list.tasks.push_back(task(object, suspect, scale));
  }
  // Where nothing is suspect, an alert is a report.
  if (!suspects_.empty()) {
    list.tasks.push_back(alert_task(scale));
  }
}

SubTask Search::task(const Room& room, const TimeScale& scale) const {
  return {
      "Enter " + room.name, room.entered.has_value(),
      room.entered ? scale.told(*room.entered, "entered") + '.' : "No robot of the team entered."};
}

SubTask Search::task(std::uint32_t object, const Suspect& suspect, const TimeScale& scale) const {
  const std::string where = suspect.room == 0 ? "" : " in " + rooms_[suspect.room - 1].name;
  std::string evidence = "Nobody tested it.";
  if (suspect.tests > 0) {
    const std::string times =
        suspect.tests == 1 ? "" : ", which was test " + std::to_string(suspect.tests) + " of it";
    evidence =
        scale.told(suspect.tested, std::string("found it ") + name(suspect.finding)) + times + '.';
  }
  return {"Test object " + std::to_string(object) + where + " once", suspect.tests == 1,
          std::move(evidence)};
}

SubTask Search::alert_task(const TimeScale& scale) const {
  const bool real = has_real();
  SubTask task{real ? "Alert on the real object and on nothing else" : "Alert on nothing",
               !false_alarm_ && (!real || alerted_), ""};
  if (false_alarm_) {
    task.evidence =
        scale.told(*false_alarm_, "alerted") +
        (real ? " without the real object having been found." : " where no object is real.");
  } else if (real) {
    task.evidence = alerted_ ? scale.told(*alerted_, "alerted") + ", after robot " +
                                   std::to_string(found_->robot.value) + " had found it " +
                                   scale.at(found_->tick) + '.'
                             : missing_alert(scale);
  } else {
    task.evidence = "There was no alert.";
  }
  return task;
}

std::string Search::missing_alert(const TimeScale& scale) const {
  return found_ ? scale.told(*found_, "found it") + ", but nobody alerted after that."
                : "Nobody found it.";
}

}  // namespace tacit
