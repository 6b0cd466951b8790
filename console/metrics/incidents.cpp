#include "console/metrics/incidents.h"

namespace tacit {

void Collisions::add(const Event& event) {
  count += std::holds_alternative<Collision>(event.what) ? 1 : 0;
}

std::vector<Metric> Collisions::metrics() const {
  return {{"collisions", "", "Times a robot began to touch something.", count}};
}

void Absences::add(const Event& event) {
  lost += std::holds_alternative<RobotLost>(event.what) ? 1 : 0;
  back += std::holds_alternative<RobotBack>(event.what) ? 1 : 0;
  late += std::holds_alternative<RobotLate>(event.what) ? 1 : 0;
}

std::vector<Metric> Absences::metrics() const {
  return {{"robots_lost", "", "Times a robot's agent was lost.", lost},
          {"robots_back", "", "Times a lost robot came back.", back},
          {"robots_late", "", "Ticks for which a robot's command came too late.", late}};
}

void Length::add(const Event& event) {
  ticks = event.tick;
  complete = complete || std::holds_alternative<RunEnded>(event.what);
}

}  // namespace tacit
