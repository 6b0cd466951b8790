#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "robot_agent/brain/perception/thing.h"
#include "robot_agent/brain/schemas/avoid_robots.h"
#include "robot_agent/brain/schemas/keep_formation.h"
#include "robot_agent/brain/schemas/move_ahead.h"
#include "robot_agent/brain/schemas/move_away_from.h"
#include "robot_agent/brain/schemas/move_to.h"
#include "robot_agent/brain/schemas/move_to_free_space.h"
#include "robot_agent/brain/schemas/move_to_place.h"
#include "robot_agent/brain/schemas/pass_doorway.h"
#include "robot_agent/brain/schemas/proceed_along.h"
#include "robot_agent/brain/schemas/pursue_enemy.h"
#include "robot_agent/brain/schemas/registry.h"
#include "robot_agent/brain/schemas/stay_on_path.h"
#include "robot_agent/brain/schemas/telop.h"

namespace tacit {

/// The schemas that automata can use. A new one needs its file pair, its test and its name here.
using UsableSchemas = TypeList<MoveTo, PursueEnemy, AvoidSoldiers, AvoidObstacles, Noise,
                               MoveToPlace, MoveAwayFrom, AvoidRobots, ProceedAlong, StayOnPath,
                               PassDoorway, MoveToFreeSpace, MoveAhead, KeepFormation, Telop>;

/// What a use of a schema brings along; without one, its parameters are the scenario's.
using SchemaSetting =
    std::variant<std::monostate, MoveTo::Config, AvoidObstacles::Config, Noise::Config,
                 MoveToPlace::Config, MoveAwayFrom::Config, AvoidRobots::Config,
                 ProceedAlong::Config, PassDoorway::Config, MoveToFreeSpace::Config,
                 MoveAhead::Config, KeepFormation::Config>;

/// A motor schema at work: which, how strongly, and on what, where it is about classes of things.
struct SchemaUse {
  std::string schema;  ///< As it is registered: "MoveTo", …
  double gain = 1.0;
  ThingSet things{};
  SchemaSetting setting{};
};

/// The schema that `use` names. Throws ConfigError when there is none of that name, when it lacks
/// the things it is to be about, or when its parameters are missing or cannot be.
[[nodiscard]] std::unique_ptr<Schema> make_schema(const SchemaUse& use,
                                                  const SchemaConfigs& configs, const Self& self);

/// Its name with what it is about: "MoveToMine".
[[nodiscard]] std::string name(const SchemaUse& use);

}  // namespace tacit
