#pragma once

#include <string>
#include <vector>

#include "idl/cdl/team.h"

namespace tacit::cdl {

struct Arrow {
  std::string from;
  std::string to;
  std::string event;  ///< The trigger's name.
  std::string label;  ///< With its parameters.
};

/// What a drawing shows as a box: a robot, one of its actuators, a state.
struct Box {
  std::string id;           ///< Letters, digits and `_`; of no other box.
  std::string label;        ///< UTF-8 without control characters.
  bool concurrent = false;  ///< What is inside goes on at the same time.
  std::string initial;      ///< Box inside that it begins in; may be none.
  std::vector<Box> inside;
  std::vector<Arrow> arrows;  ///< Between boxes inside.
};

/// One box with a box for each robot. Rules that lead nowhere are left out.
[[nodiscard]] Box diagram_of(const std::vector<Robot>& robots);

/// A state diagram of Mermaid.
[[nodiscard]] std::string to_mermaid(const Box& team);
/// A directed graph of Graphviz.
[[nodiscard]] std::string to_dot(const Box& team);
/// A document of State Chart XML (W3C 2015), with the labels as attributes of a namespace of ours.
[[nodiscard]] std::string to_scxml(const Box& team);

}  // namespace tacit::cdl
