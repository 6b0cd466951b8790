#pragma once

#include <string>

#include "robot_agent/brain/brain.h"
#include "robot_agent/brain/brain_config.h"

namespace tacit::testing {

/// A mission of one robot, whose automaton has these states and rules.
inline std::string mission_of(const std::string& states_and_rules) {
  return "bindArch AuRA.urban;\n"
         "instBP<0,0> $AN_1 from movement(v<0,0> = , bound_to = base:DRIVE(v<0,0> = FSA(\n" +
         states_and_rules +
         "),\nmax_vel = {2.0}, base_vel = {1.0}, cautious_vel = {0.1}, cautious_mode = {false}));\n"
         "instBP<0,0> $AN_2 from vehicle(bound_to = One:MRV2(One:[$AN_1]));\n[ $AN_2 ]\n";
}

/// "society[name] = [ parameters, Behaviour ],"
inline std::string state(const std::string& name, const std::string& behaviour) {
  return "society[" + name + "]<1,1>|" + name + "| = [" + behaviour + "],\n";
}
inline std::string rule(const std::string& from, const std::string& trigger,
                        const std::string& to) {
  return "rules[" + from + "] = if [" + trigger + "] goto " + to + ",\n";
}
/// The last item of a list has no comma behind it.
inline std::string last(std::string items) { return items.substr(0, items.size() - 2); }

/// A robot that carries out a mission; it is told that it starts at `start`: x, y, heading.
class MissionRobot {
 public:
  explicit MissionRobot(const std::string& mission, std::vector<double> start = {0.0, 0.0, 0.0})
      : brain_(config(mission, std::move(start)), RobotId{1}, 7) {}

  /// Answers the percept, at the next tick.
  Command see(Percept percept = {}) {
    percept.robot = {1};
    percept.tick = tick_++;
    return brain_.decide(percept);
  }
  [[nodiscard]] std::string state() const {
    Telemetry telemetry;
    brain_.report(telemetry);
    return telemetry.state;
  }
  [[nodiscard]] Brain& brain() { return brain_; }
  void skip_to(Tick tick) { tick_ = tick; }

  static BrainConfig config(const std::string& mission, std::vector<double> start) {
    BrainConfig config = brain_defaults(MissionKind::Operation);
    config.script.mission = mission;
    config.script.starts = {std::move(start)};
    return config;
  }

 private:
  Brain brain_;
  Tick tick_ = 0;
};

}  // namespace tacit::testing
