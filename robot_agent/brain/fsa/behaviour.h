#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idl/types/command.h"
#include "idl/types/repulsion.h"
#include "idl/types/telemetry.h"
#include "robot_agent/brain/fsa/entry.h"
#include "robot_agent/brain/fsa/record.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// What comes out of a tick. Empty by default.
struct Doing {
  BodyVec sum;  ///< A weighted sum of pushes.
  Act act = Act::None;
  std::optional<Colour> about;  ///< As a command has it, like `word`.
  Word word;
  std::optional<double> turn_rad;  ///< Wanted turn on the spot, counter-clockwise.
  bool hemmed_in = false;          ///< Something is inside a safety margin.

  /// Adds a schema's push, times its gain.
  void add(double gain, const BodyVec& push) {
    sum += gain * push;
    hemmed_in = hemmed_in || push.squared_norm() >= kInfiniteRepulsion * kInfiniteRepulsion;
  }
};

/// What a robot does in a state: a weighted sum, an automaton of its own, a choice that it learns.
class Behaviour {
 public:
  virtual ~Behaviour() = default;

  /// Begins it anew; nothing comes out in that tick.
  virtual void enter(const Entry& entry) = 0;
  /// One tick, ticks ascending, the first after `enter`.
  [[nodiscard]] virtual Doing step(const Surroundings& around) = 0;
  /// The shares in the last step; none pushes when there was no step since `enter`.
  virtual void report(std::vector<SchemaShare>& shares) const = 0;
  /// Adds the names of the states that it is in, from the outside in, after a slash each.
  virtual void name_states(std::string& /*path*/) const {}
  /// The task is done: with which word, several when they mean the same. Empty while it goes on.
  [[nodiscard]] virtual std::span<const Word> exit() const { return {}; }

  /// Writes where it stands; `resume` takes it up again in a robot with the same mission. False
  /// when the record cannot be one of this behaviour.
  virtual void note(Record& record) const = 0;
  [[nodiscard]] virtual bool resume(RecordReader& record) = 0;
  /// Another run begins with what has been learned so far.
  virtual void begin_run() {}
  /// Grows whenever something was learned.
  [[nodiscard]] virtual std::uint64_t lessons() const { return 0; }
};

}  // namespace tacit
