#include "console/live/graph.h"

#include <array>
#include <string>
#include <utility>

#include "idl/topics/topics.h"

namespace tacit {
namespace {

std::string agent(std::int64_t robot) { return "robot_agent " + std::to_string(robot); }

constexpr std::array<std::pair<Party, const char*>, 3> kTeamParties{
    {{Party::World, "world_server"}, {Party::Console, "console"}, {Party::Launcher, "tacit"}}};

/// `robot` is 0 for a topic of the team, to which every agent may belong.
void add(std::set<std::string>& ends, Parties parties, std::int64_t robot, std::int64_t robots) {
  for (const auto& [party, name] : kTeamParties) {
    if (parties.contains(party)) ends.insert(name);
  }
  if (!parties.contains(Party::Agent)) return;
  if (robot != 0) {
    ends.insert(agent(robot));
  } else {
    for (std::int64_t one = 1; one <= robots; ++one) ends.insert(agent(one));
  }
}

}  // namespace

gateway::ConnectionGraph connection_graph(std::int64_t robots) {
  gateway::ConnectionGraph graph;
  for_each_topic([&](auto topic) {
    using Topic = decltype(topic);
    if (Topic::kWriters.contains(Party::Wizard) || Topic::kReaders.contains(Party::Wizard)) return;
    const bool of_robots = Topic::kScope == Scope::Robot;
    for (std::int64_t robot = of_robots ? 1 : 0; robot <= (of_robots ? robots : 0); ++robot) {
      const std::string name = '/' + topic_name<Topic>(RobotId{static_cast<std::uint16_t>(robot)});
      add(graph.publishers[name], Topic::kWriters, robot, robots);
      add(graph.subscribers[name], Topic::kReaders, robot, robots);
    }
  });
  return graph;
}

}  // namespace tacit
