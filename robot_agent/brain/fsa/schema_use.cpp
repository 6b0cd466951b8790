#include "robot_agent/brain/fsa/schema_use.h"

#include "idl/types/config_error.h"

namespace tacit {
namespace {

template <class Config, class Variant>
inline constexpr bool kHolds = false;
template <class Config, class... Each>
inline constexpr bool kHolds<Config, std::variant<Each...>> = (std::is_same_v<Config, Each> || ...);

/// Whether the scenario has parameters for `S`.
template <class S>
inline constexpr bool kInScenario = []<class... Each>(TypeList<Each...>) {
  return (std::is_same_v<S, Each> || ...);
}(SchemaTypes{});

/// The parameters in `use`, null when it has none that fit.
template <class S>
const auto* setting_of(const SchemaUse& use) {
  if constexpr (requires { typename S::Config; }) {
    if constexpr (kHolds<typename S::Config, SchemaSetting>) {
      return std::get_if<typename S::Config>(&use.setting);
    } else {
      return static_cast<const typename S::Config*>(nullptr);
    }
  } else {
    return static_cast<const std::monostate*>(nullptr);
  }
}

template <class S, class Config>
std::unique_ptr<Schema> make_with(const SchemaUse& use, const Config& config, const Self& self) {
  if constexpr (std::is_constructible_v<S, ThingSet, const Config&>) {
    return std::make_unique<S>(use.things, config);
  } else if constexpr (std::is_constructible_v<S, const Config&, const Self&>) {
    return std::make_unique<S>(config, self);
  } else if constexpr (std::is_constructible_v<S, const Config&>) {
    return std::make_unique<S>(config);
  } else {
    return std::make_unique<S>();
  }
}

template <class S>
std::unique_ptr<Schema> make(const SchemaUse& use, const SchemaConfigs& configs, const Self& self) {
  constexpr bool kAboutThings =
      std::is_constructible_v<S, ThingSet> || std::is_same_v<S, MoveAwayFrom>;
  if (kAboutThings && use.things.empty()) {
    throw ConfigError("schema " + use.schema + " lacks a thing to be about");
  }
  if (const auto* config = setting_of<S>(use)) return make_with<S>(use, *config, self);
  if constexpr (std::is_constructible_v<S, ThingSet>) {
    return std::make_unique<S>(use.things);
  } else if constexpr (std::is_default_constructible_v<S>) {
    return std::make_unique<S>();
  } else if constexpr (kInScenario<S>) {
    return make_schema<S>(configs, self);
  } else {
    throw ConfigError("schema " + use.schema + " lacks its parameters");
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

std::string name(const SchemaUse& use) { return use.schema + name(use.things); }

}  // namespace tacit
