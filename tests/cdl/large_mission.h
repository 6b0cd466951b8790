#pragma once

#include <cstddef>
#include <string>

namespace tacit::cdl {

/// A robot whose automaton has so many states, one behind the other. The file names it `$R` and
/// its number.
inline std::string large_robot(std::size_t number, std::size_t states) {
  std::string text = "instBP<222,15> |wheels| $M" + std::to_string(number) +
                     " from movement(\n  base_vel = {0.2},\n  bound_to = base:DRIVE_W_SPIN(\n"
                     "    v<12,15> = FSA(\n      society[Start]<50,50>|Start| = [Stop]<10,10>";
  std::string before = "Start";
  for (std::size_t i = 0; i < states; ++i) {
    const std::string name = "$S" + std::to_string(i);
    text += ",\n      society[" + name + "]<" + std::to_string(i * 40) + ",50>|Look " + name +
            "| = [\n        %Objects = {Mines | Robots},\n        %max_sensor_range = {35.5},\n"
            "        MoveToward]<10,10>,\n      rules[" +
            before + "]<0,0> = if [\n        %Goal_Tolerance = {0.5},\n        AtGoal]<3,4> goto " +
            name;
    before = name;
  }
  text += ",\n      rules[" + before + "] = if [ Immediate] goto Start";
  return text + ")<9,9>|machine|,\n    max_vel = {0.5})<1,1>);\ninstRobot<0,0> $R" +
         std::to_string(number) + " from vehicle(\n  bound_to = one:MRV2(\none:[ $M" +
         std::to_string(number) + "])<0,0>|robot|);\n";
}

/// A mission without findings of some `bytes`, of one robot at least.
inline std::string large_mission(std::size_t bytes, std::size_t states = 100) {
  std::string text = "bindArch AuRA.urban;\n";
  std::string team;
  for (std::size_t i = 0; i == 0 || text.size() + team.size() < bytes; ++i) {
    text += large_robot(i, states);
    team += (i == 0 ? "" : ", ") + ("$R" + std::to_string(i));
  }
  return text + "Team:[" + team + "]<10,10>\n";
}

}  // namespace tacit::cdl
