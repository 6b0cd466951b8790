#include "robot_agent/brain/roles/forager.h"

#include "robot_agent/brain/roles/activities.h"

namespace tacit {

AutomatonPlan forager(const RolesConfig& config) {
  const auto& c = config;
  const ActivityPlan to_mine = approach(Thing::Mine, c);
  const ActivityPlan to_base = approach(Thing::Base, c);
  // clang-format off
  return {"Forager", {
      // state         activity             if                                   goto
      {"LookForMine",  wander(c),          {{Holding{},                          "MoveToBase"},
                                            {Detect{Thing::Mine},                "MoveToMine"}}},
      {"MoveToMine",   to_mine,            {{Holding{},                          "MoveToBase"},
                                            {NotDetected{Thing::Mine},           "LookForMine"},
                                            {Near{Thing::Mine, c.near_mine_m},   "PickUp"}}},
      {"PickUp",       stand(Act::PickUp), {{Holding{},                          "MoveToBase"},
                                            {AwayFrom{Thing::Mine, c.pick_up_reach_m},
                                                                                 "LookForMine"}}},
      {"MoveToBase",   to_base,            {{NotHolding{},                       "LookForMine"},
                                            {NotDetected{Thing::Base},           "LookForBase"},
                                            {Near{Thing::Base, c.near_base_m},   "Drop"}}},
      {"LookForBase",  wander(c),          {{NotHolding{},                       "LookForMine"},
                                            {Detect{Thing::Base},                "MoveToBase"}}},
      {"Drop",         stand(Act::Drop),   {{NotHolding{},                       "LookForMine"},
                                            {AwayFrom{Thing::Base, c.drop_reach_m},
                                                                                 "MoveToBase"}}},
  }};
  // clang-format on
}

}  // namespace tacit
