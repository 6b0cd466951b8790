#pragma once

#include <array>
#include <memory>
#include <tuple>
#include <type_traits>

#include "idl/types/telemetry.h"
#include "robot_agent/brain/schemas/avoid_obstacles.h"
#include "robot_agent/brain/schemas/avoid_soldiers.h"
#include "robot_agent/brain/schemas/intercept_enemies.h"
#include "robot_agent/brain/schemas/move_to_target.h"
#include "robot_agent/brain/schemas/noise.h"
#include "robot_agent/brain/type_list.h"

namespace tacit {

/// The motor schemas of a guard. A new one needs its file pair, its test and its name here; its
/// parameters and its gains in every assemblage follow. (Those that automata use stand in
/// `fsa/schema_use.cpp`.)
using SchemaTypes = TypeList<MoveToTarget, InterceptEnemies, AvoidSoldiers, AvoidObstacles, Noise>;

static_assert(SchemaTypes::kSize <= Telemetry::kMaxShares);

/// Calls `visit.operator()<S>()` for each schema type S, in the order of the list.
template <class Visit>
void for_each_schema(Visit&& visit) {
  [&visit]<class... S>(TypeList<S...>) { (visit.template operator()<S>(), ...); }(SchemaTypes{});
}

/// The place of schema type `S` in the list.
template <class S>
inline constexpr std::size_t kSchemaIndex = []<class... T>(TypeList<T...>) {
  static_assert((std::is_same_v<S, T> || ...), "not a registered schema");
  std::size_t index = 0;
  static_cast<void>(((std::is_same_v<S, T> || (++index, false)) || ...));
  return index;
}(SchemaTypes{});

/// The parameters of all schemas.
using SchemaConfigs = decltype([]<class... S>(TypeList<S...>) {
  return std::tuple<typename S::Config...>{};
}(SchemaTypes{}));

/// Throws what the constructor of `S` throws.
template <class S>
[[nodiscard]] std::unique_ptr<Schema> make_schema(const SchemaConfigs& configs, const Self& self) {
  const auto& config = std::get<typename S::Config>(configs);
  if constexpr (std::is_constructible_v<S, const typename S::Config&, const Self&>) {
    return std::make_unique<S>(config, self);
  } else {
    return std::make_unique<S>(config);
  }
}

/// One weight per schema, 0 by default.
struct Gains {
  std::array<double, SchemaTypes::kSize> value{};

  template <class S>
  [[nodiscard]] double& of() {
    return value[kSchemaIndex<S>];
  }
  template <class S>
  [[nodiscard]] double of() const {
    return value[kSchemaIndex<S>];
  }
  friend bool operator==(const Gains&, const Gains&) = default;
};

}  // namespace tacit
