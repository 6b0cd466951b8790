#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "idl/types/command.h"
#include "robot_agent/brain/fsa/schema_use.h"
#include "robot_agent/brain/learning/q_learner.h"
#include "robot_agent/brain/triggers/registry.h"

namespace tacit {

/// What a robot does in a state beside moving.
struct Deed {
  Act act = Act::None;
  std::optional<Colour> about = std::nullopt;  ///< As a command has it, like `word`.
  Word word{};
  Tick after_ticks = 0;  ///< It begins so long after the state was entered.
  bool once = false;     ///< In one tick alone, not until the state is left.
};

/// How a robot turns on the spot.
enum class Turn : std::uint8_t {
  None,       ///< As it moves.
  AboutFace,  ///< Until it faces against the direction in which the state was entered.
  Scan,       ///< On and on.
};

/// What a robot does in one state: a weighted sum of schemas, and a deed beside it.
struct ActivityPlan {
  std::vector<SchemaUse> schemas{};
  Deed deed{};
  Turn turn = Turn::None;
  std::vector<Word> exit{};  ///< In this state the task is done, with this word.
};

/// A weighted sum whose gains follow the robot's progress (MissionLab's learning momentum for one
/// robot): a goal to go to, obstacles to avoid, and noise.
struct MomentumPlan {
  SchemaUse goal;
  double obstacle_gain = 1.0;
  double obstacle_sphere_m = 3.0;
  double obstacle_margin_m = 0.5;
  double noise_gain = 0.0;
};

/// "If trigger goto next."
struct Rule {
  Trigger trigger;
  std::string next;  ///< A state of the same automaton.
};

struct AutomatonPlan;
struct ChoicePlan;

/// The first of `nested`, `choice` and `momentum` that there is says what is done, else `activity`.
struct StatePlan {
  std::string name{};
  ActivityPlan activity{};
  std::vector<Rule> rules{};  ///< The first that fires wins.
  std::shared_ptr<const AutomatonPlan> nested = nullptr;
  std::shared_ptr<const ChoicePlan> choice = nullptr;
  std::optional<MomentumPlan> momentum = std::nullopt;
};

/// An automaton as a table, in code or out of a mission file. The first state is the initial one.
struct AutomatonPlan {
  std::string name;
  std::vector<StatePlan> states;
};

/// A learner that chooses among actions (MissionLab's QLEARN).
struct ChoicePlan {
  /// A reward that comes with a state and an action; empty means any.
  struct Reinforcer {
    std::optional<std::size_t> state;
    std::optional<std::size_t> action;
    double reward = 0.0;
  };
  std::string name;
  std::vector<StatePlan> actions;  ///< Without rules.
  std::vector<Trigger> triggers;   ///< At most 12.
  std::vector<Reinforcer> reinforcers;
  QLearner::Config learner;
  Tick action_timeout = 300;
};

}  // namespace tacit
