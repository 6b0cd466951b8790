#include "robot_agent/brain/fsa/schema_use.h"

#include "idl/types/config_error.h"
#include "robot_agent/brain/schemas/move_to.h"
#include "robot_agent/brain/schemas/pursue_enemy.h"

namespace tacit {
namespace {

/// The schemas that automata can use. A new one needs its file pair, its test and its name here.
using UsableSchemas = TypeList<MoveTo, PursueEnemy, AvoidSoldiers, AvoidObstacles, Noise>;

template <class S>
std::unique_ptr<Schema> make(const SchemaUse& use, const SchemaConfigs& configs, const Self& self) {
  if constexpr (std::is_constructible_v<S, Thing>) {
    if (!use.thing) throw ConfigError("schema " + use.schema + " lacks a thing to be about");
    return std::make_unique<S>(*use.thing);
  } else if constexpr (std::is_default_constructible_v<S>) {
    return std::make_unique<S>();
  } else {
    return make_schema<S>(configs, self);
  }
}

}  // namespace

std::unique_ptr<Schema> make_schema(const SchemaUse& use, const SchemaConfigs& configs,
                                    const Self& self) {
  std::unique_ptr<Schema> schema;
  const auto try_one = [&]<class S>() {
    if (use.schema == S::kName) schema = make<S>(use, configs, self);
  };
  [&]<class... S>(TypeList<S...>) { (try_one.template operator()<S>(), ...); }(UsableSchemas{});
  if (!schema) throw ConfigError("there is no schema called " + use.schema);
  return schema;
}

std::string name(const SchemaUse& use) {
  return use.thing ? use.schema + std::string(name(*use.thing)) : use.schema;
}

}  // namespace tacit
