#pragma once

#include <span>
#include <string_view>

#include "idl/topics/topics.h"

namespace tacit {

/// What the bytes of a wire type mean, for other people's tools: ROS 2 message text ("ros2msg"),
/// made from the IDL when the project is built.
struct WireSchema {
  std::string_view name;  ///< "tacit_wire/msg/WorldView".
  std::string_view text;
};

/// Of every struct in idl/wire.
[[nodiscard]] std::span<const WireSchema> schemas();

/// The text of the schema of that name; empty when there is none.
[[nodiscard]] std::string_view ros2msg_schema(std::string_view type);

/// The name of a topic's schema, "tacit_wire/msg/EventBatch".
template <class Topic>
[[nodiscard]] std::string_view schema_name();

/// The schema of a topic for people.
template <class Topic>
[[nodiscard]] WireSchema schema_of() {
  return {schema_name<Topic>(), ros2msg_schema(schema_name<Topic>())};
}

template <>
inline std::string_view schema_name<topics::WorldView>() {
  return "tacit_wire/msg/WorldView";
}
template <>
inline std::string_view schema_name<topics::Trajectory>() {
  return "tacit_wire/msg/WorldView";
}
template <>
inline std::string_view schema_name<topics::Status>() {
  return "tacit_wire/msg/RunStatus";
}
template <>
inline std::string_view schema_name<topics::Events>() {
  return "tacit_wire/msg/EventBatch";
}
template <>
inline std::string_view schema_name<topics::Telemetry>() {
  return "tacit_wire/msg/Telemetry";
}

}  // namespace tacit
