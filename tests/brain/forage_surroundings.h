#pragma once

#include "robot_agent/brain/brain_config.h"
#include "robot_agent/brain/perception/forage_perception.h"
#include "tests/brain/percepts.h"

namespace tacit::testing {

/// A percept and what a forager's perception makes of it, at successive ticks.
class ForageEyes {
 public:
  const Surroundings& look(Percept percept) {
    now_ = std::move(percept);
    now_.tick = tick_++;
    return perception_.look(now_);
  }
  const Surroundings& look(std::vector<Sighting> sightings) {
    return look(percept(0, std::move(sightings)));
  }
  [[nodiscard]] Tick next_tick() const { return tick_; }

 private:
  ForagePerception perception_{1.2, BrainConfig{}.pursuit};
  Percept now_;
  Tick tick_ = 0;
};

inline Percept holding(std::vector<Sighting> sightings) {
  Percept now = percept(0, std::move(sightings));
  now.holding = true;
  return now;
}

}  // namespace tacit::testing
