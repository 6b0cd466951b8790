#include "deploy/tacit/remake.h"

#include <fstream>

#include "console/record/event_log.h"
#include "deploy/lockstep/setup.h"
#include "deploy/lockstep/team.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

/// A recorded log, read beside the run made again.
class Comparison {
 public:
  explicit Comparison(const std::filesystem::path& log) : in_(log, std::ios::binary) {
    if (!in_) {
      throw ConfigError(log.string() + ": cannot be read, wanted an event log");
    }
  }

  void take(std::span<const Event> events) {
    result_.add(events);
    for (const Event& event : events) {
      compare(to_line(event), event.tick);
    }
  }

  Remake finish(Tick ticks) {
    compare("", ticks);
    return {result_.hex(), ticks, difference_};
  }

 private:
  void compare(const std::string& remade, Tick tick) {
    if (difference_) {
      return;
    }
    std::string recorded;
    std::getline(in_, recorded);
    ++line_;
    if (recorded != remade) {
      difference_ = Difference{line_, tick, recorded, remade};
    }
  }

  std::ifstream in_;
  EventHash result_;
  std::uint64_t line_ = 0;
  std::optional<Difference> difference_;
};

}  // namespace

Remake remake(const RunDirectory& directory) {
  ScenarioFile file = ScenarioFile::read(directory.scenario_file());
  const Setup setup = read_setup(file);
  Comparison comparison(directory.events_file());
  Team team(setup.world, setup.brain, seed(setup));
  if (const auto policies = directory.inherited().load(setup.world.robots.count);
      !policies.empty()) {
    team.inherit(policies);
  }
  while (!team.done(last_tick(setup))) {
    comparison.take(team.step());
  }
  const Event ending = team.ending();
  comparison.take({&ending, 1});
  return comparison.finish(team.tick());
}

}  // namespace tacit
