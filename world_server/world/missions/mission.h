#pragma once

#include "idl/types/roster.h"
#include "idl/types/world_view.h"
#include "world_server/world/digest.h"
#include "world_server/world/stage.h"

namespace tacit {

/// The rules of a mission: who comes and goes, what robots bring about beside moving, when it ends.
///
/// A step from one tick to the next asks for `set_out`, moves the bodies, asks for `settle`, counts
/// the tick, asks for `conclude` and, when the robots have looked around, for `perceive`.
class Mission {
 public:
  Mission() = default;
  virtual ~Mission() = default;
  Mission(const Mission&) = delete;
  Mission& operator=(const Mission&) = delete;

  /// Before the motion, with the robots' velocities set: brings visitors in and drives them.
  virtual void set_out(Stage& stage) = 0;
  /// After the motion, before the tick counts: what it led to.
  virtual void settle(Stage& stage) = 0;
  /// At the new tick, after its checkpoint: the last event of the step, if any.
  virtual void conclude(Stage& /*stage*/) {}

  /// What robots perceive beside what their eyes show; also before the first step.
  virtual void perceive(Stage& /*stage*/) {}
  /// What an operator tells, for the next step; false when it is nothing to this mission.
  virtual bool hear(const Control& /*control*/) { return false; }

  /// Whether the mission has come to its end.
  [[nodiscard]] virtual bool over() const { return false; }
  /// The part of the state that only this mission has.
  virtual void add_to(Digest& /*digest*/, const Stage& /*stage*/) const {}
  /// What a spectator sees beside bodies.
  virtual void show(WorldView& /*out*/) const {}
};

}  // namespace tacit
