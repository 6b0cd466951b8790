#pragma once

#include <span>
#include <string>

#include "idl/schema/idl_text.h"

namespace tacit {

/// "tacit_wire/msg/WorldView" for the struct WorldView of the module tacit::wire.
[[nodiscard]] std::string ros2msg_name(const IdlStruct& of);

/// The schema of `of` as ROS 2 message text: its members, then the structs that it is made of, each
/// once, behind a line of 80 `=` and one that names it. `all` holds them.
///
/// An array of several dimensions is one of as many members; its bytes are the same.
[[nodiscard]] std::string ros2msg_text(const IdlStruct& of, std::span<const IdlStruct> all);

}  // namespace tacit
