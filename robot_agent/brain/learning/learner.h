#pragma once

#include <string>
#include <string_view>

#include "robot_agent/brain/schemas/registry.h"

namespace tacit {

/// What sets the gains of a brain's assemblage.
class Learner {
 public:
  virtual ~Learner() = default;

  /// Takes this tick in; afterwards `gains()` are the ones to act by. Ticks ascending.
  virtual void learn(const Surroundings& around) = 0;
  [[nodiscard]] virtual const Gains& gains() const = 0;
  /// The largest gain that each schema can ever get.
  [[nodiscard]] virtual Gains ceiling() const = 0;
  /// The name of the situation judged last; empty when there is none.
  [[nodiscard]] virtual std::string_view situation() const = 0;
  /// As `Brain::memory` and `Brain::recall`.
  [[nodiscard]] virtual std::string memory() const = 0;
  [[nodiscard]] virtual bool recall(std::string_view memory) = 0;
};

}  // namespace tacit
