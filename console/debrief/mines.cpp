#include "console/debrief/mines.h"

#include <string>

#include "idl/overlay/tokens.h"

namespace tacit {

MinesToStore::MinesToStore(const MapPlan& plan) {
  std::uint32_t number = 0;
  for (const MapObject& object : plan.objects) {
    ++number;
    if (object.mobility == Mobility::Movable && capitals(object.colour) == "ORANGE") {
      stored_[number] = std::nullopt;
    }
  }
}

void MinesToStore::add(const Event& event, const TeamWatch& team) {
  const auto* stored = std::get_if<ObjectStored>(&event.what);
  if (stored == nullptr || !team.in_team(stored->robot)) return;
  const auto mine = stored_.find(stored->object.value);
  if (mine != stored_.end() && !mine->second) {
    mine->second = Deed{stored->robot, event.tick};
  }
}

void MinesToStore::append_to(Checklist& list, const TimeScale& scale) const {
  for (const auto& [object, stored] : stored_) {
    list.tasks.push_back({"Store the mine that is object " + std::to_string(object),
                          stored.has_value(),
                          stored ? scale.told(*stored, "put it into a container") + '.'
                                 : "Nobody put it into a container."});
  }
}

}  // namespace tacit
