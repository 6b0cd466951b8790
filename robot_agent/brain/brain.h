#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "idl/types/command.h"
#include "idl/types/percept.h"
#include "idl/types/telemetry.h"
#include "robot_agent/brain/brain_config.h"

namespace tacit {

class Mind;

/// A robot's mind: a function from what it senses now, and what it remembers, to what it does.
///
/// Pure: no clock, no thread, no file, no communication. Two brains with the same configuration,
/// robot, seed and percepts decide the same.
class Brain {
 public:
  /// Throws ConfigError when `config` contradicts itself.
  Brain(const BrainConfig& config, RobotId robot, std::uint64_t seed);
  ~Brain();
  Brain(Brain&&) noexcept;
  Brain& operator=(Brain&&) noexcept;

  /// The answer to `percept`; call once per tick, ticks ascending.
  [[nodiscard]] Command decide(const Percept& percept);

  /// Writes what went on in the last decision into `out`; the counters are the process's and stay
  /// as they are.
  void report(Telemetry& out) const;

  /// What has been learned and where the brain stands, so that it can go on after a crash.
  [[nodiscard]] std::string memory() const { return memory(policy()); }
  /// The same for who has the policy of this moment already: it is a part of the memory, and long.
  [[nodiscard]] std::string memory(std::string_view policy) const;
  /// Takes up where `memory()` left off. False, and nothing changed, when the text is not one that
  /// this configuration wrote.
  [[nodiscard]] bool recall(std::string_view memory);
  /// Grows whenever something was learned that must not be lost with the process.
  [[nodiscard]] std::uint64_t lessons() const;

  /// What has been learned and serves another run as well; the format is the learner's.
  [[nodiscard]] std::string policy() const;
  /// Begins this run, at its tick 0, with what an earlier run of the same robot learned. `name` is
  /// the policy's name in errors. Throws ConfigError when `policy` is not one for this
  /// configuration.
  void inherit(std::string_view policy, std::string_view name);

 private:
  std::unique_ptr<Mind> mind_;
};

}  // namespace tacit
