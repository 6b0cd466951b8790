#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "robot_agent/brain/learning/role_triggers.h"
#include "robot_agent/brain/learning/run_stand.h"

namespace tacit {

/// What a choice of role hangs on.
struct RoleCue {
  const Surroundings& around;
  TriggerSet triggers;
  bool revived = false;  ///< It was disabled in the tick before.
};

/// What chooses the role of a foraging team's robot. One that learns overrides all; the others
/// have nothing to keep but their name.
class RoleSelector {
 public:
  explicit RoleSelector(std::string_view learner) : learner_(learner) {}
  virtual ~RoleSelector() = default;
  RoleSelector(const RoleSelector&) = delete;
  RoleSelector& operator=(const RoleSelector&) = delete;

  /// The role from this tick on. Call once per tick in which the robot is able, ticks ascending.
  [[nodiscard]] virtual Role choose(const RoleCue& cue) = 0;

  /// As `Brain`'s.
  [[nodiscard]] virtual std::string policy() const;
  virtual void inherit(std::string_view policy, std::string_view name);
  [[nodiscard]] virtual std::uint64_t lessons() const { return 0; }

  /// Notes what a choice hangs on beside the policy.
  virtual void note(RunStand& /*stand*/) const {}
  /// Goes on from there. False, and nothing changed, when the two are not what this configuration
  /// wrote.
  [[nodiscard]] virtual bool resume(const RunStand& stand, std::string_view policy);

 private:
  std::string learner_;
};

}  // namespace tacit
