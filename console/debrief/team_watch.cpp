#include "console/debrief/team_watch.h"

namespace tacit {

void TeamWatch::add(const Event& event) {
  if (const auto* entered = std::get_if<SiteEntered>(&event.what)) {
    if (in_team(entered->robot)) {
      where_[entered->robot.value - 1U] = {entered->site, entered->number};
    }
  } else if (const auto* said = std::get_if<Signalled>(&event.what)) {
    alarm_ = is_call(*said, kEnemyFound) || (alarm_ && !is_call(*said, kHallwayClear));
  }
}

}  // namespace tacit
