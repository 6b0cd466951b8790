#pragma once

#include <string>
#include <variant>
#include <vector>

#include "idl/cdl/model.h"
#include "idl/cdl/value.h"

namespace tacit::cdl {

/// As it takes effect: a value from above is replaced by the value above.
struct Parameter {
  std::string name;
  Value value;
  Span span{};
};

struct State;
struct Member;

/// One of the library's, known by name alone, with what it reads from.
struct Primitive {
  std::vector<Member> inputs;
};

/// `FSA`: one state at a time.
struct Automaton {
  std::vector<State> states;  ///< In the file's order.
};

/// `COOP`: all at once, their outputs times their weights added up.
struct WeightedSum {
  std::vector<Member> members;
};

/// Rewards `{state, action, value}` as the file gives them.
using Reinforcer = std::vector<double>;

/// `QLEARN`: one action at a time, chosen by what the triggers say.
struct Learner {
  std::vector<Member> actions;
  std::vector<Member> triggers;
  std::vector<Reinforcer> reinforcers;
};

/// A behaviour or trigger with its parameters.
struct Behaviour {
  std::string name;         ///< `GoTo`, `FSA`, `NOISE`, …; empty when there is none.
  std::string description;  ///< What the editor shows.
  std::vector<Parameter> parameters;
  std::variant<Primitive, Automaton, WeightedSum, Learner> form;
};

/// Part of a behaviour that is connected to it by name.
struct Member {
  std::string slot;   ///< `members`, `robot_heading`, …
  std::string index;  ///< `A` of `members[A]`.
  Value weight;       ///< Of a weighted sum: a number unless the file has another word for it.
  Behaviour behaviour;
};

/// `if trigger goto target`.
struct Rule {
  Behaviour trigger;
  std::string target;
  Span span{};
};

/// A state of an automaton with the rules out of it, tested in this order, the first true one wins.
struct State {
  std::string name;   ///< `Start`, `$AN_12`.
  std::string label;  ///< What the editor shows.
  std::optional<Place> place;
  Behaviour behaviour;
  std::vector<Rule> rules;
  Span span{};
};

/// An actuator or sensor of a robot.
struct Device {
  std::string name;     ///< `base`, `camera`.
  std::string type;     ///< `DRIVE_W_SPIN`, `PANTILT`.
  std::string binding;  ///< `movement`, `pantilt`, `sense_location`.
  std::vector<Parameter> parameters;
  std::vector<Member> inputs;  ///< What drives it.
};

struct Robot {
  std::string name;
  std::string type;  ///< `PIONEERAT`, `MRV2`.
  std::vector<Device> actuators;
  std::vector<Device> sensors;
  Span span{};
};

}  // namespace tacit::cdl
