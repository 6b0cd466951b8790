#pragma once

#include "robot_agent/brain/learning/learner.h"

namespace tacit {

/// Gains that never change: the paper's Static1 and Static2 soldiers, and crowds.
class FixedGains final : public Learner {
 public:
  FixedGains(std::string_view learner, const Gains& gains) : learner_(learner), gains_(gains) {}

  void learn(const Surroundings& /*around*/) override {}
  [[nodiscard]] const Gains& gains() const override { return gains_; }
  [[nodiscard]] Gains ceiling() const override { return gains_; }
  [[nodiscard]] std::string_view situation() const override { return {}; }
  [[nodiscard]] std::string memory() const override {
    return R"({"learner":")" + learner_ + R"("})";
  }
  [[nodiscard]] bool recall(std::string_view text) override { return text == memory(); }

 private:
  std::string learner_;
  Gains gains_;
};

}  // namespace tacit
