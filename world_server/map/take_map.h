#pragma once

#include "idl/scenario/scenario_file.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// Reads the map that `world.area.map` names, if any, into `world`, which `file` has filled: size,
/// walls, discs, mines, and the target or base at its start place. Then `map` is empty, so the
/// configuration, written out, needs the map no more.
///
/// The map's walls and discs stand beside the scenario's own. Of the other values, those of the map
/// win over whoever came before the one who named the map: a map named in the scenario fills in
/// what that file leaves out, one named on the command line wins over the file as well. In the same
/// way there are no random obstacles and the robots start gathered, unless somebody says otherwise.
///
/// An operation has its map's text in `world.operation.script.map`, where it stays, since the world
/// needs all of it; a map that `world.area.map` names is read to there. Its size, walls and discs
/// are written out all the same; what is there already does not come twice.
///
/// A map named in the scenario is looked for beside the file, one named elsewhere in the working
/// directory. Throws ConfigError when it cannot be read, has errors, or does not fit.
void take_map(WorldConfig& world, const ScenarioFile& file);

}  // namespace tacit
