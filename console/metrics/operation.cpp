#include "console/metrics/operation.h"

namespace tacit {
namespace {

struct Count {
  Operation& operation;

  void operator()(const OperationBegun& e) const { operation.team = e.team; }
  void operator()(const SiteEntered& e) const {
    operation.rooms += e.site == Site::Room && ours(e.robot) ? 1 : 0;
  }
  void operator()(const ObjectTested& e) const {
    ++operation.tested;
    operation.dangerous += e.finding == Finding::Dangerous ? 1 : 0;
  }
  void operator()(const ObjectStored& /*e*/) const { ++operation.stored; }
  void operator()(const Signalled& /*e*/) const { ++operation.signals; }
  void operator()(const Alerted& /*e*/) const { ++operation.alerts; }
  void operator()(const RobotExposed& e) const { operation.exposures += e.exposed ? 1 : 0; }
  void operator()(const RobotFinished& e) const { operation.finished += ours(e.robot) ? 1 : 0; }
  void operator()(const MissionOver& e) const { operation.end = e; }
  template <class Other>
  void operator()(const Other& /*e*/) const {}

 private:
  [[nodiscard]] bool ours(RobotId robot) const { return robot.value <= operation.team.value_or(0); }
};

}  // namespace

void Operation::add(const Event& event) { std::visit(Count{*this}, event.what); }

std::vector<Metric> Operation::metrics() const {
  if (!team) {
    return {};
  }
  const bool accomplished = end && end->verdict == Verdict::Accomplished;
  const auto score =
      end ? std::optional(static_cast<double>(end->score_ticks)) : std::optional<double>();
  return {{"score_ticks", "", "Ticks until the mission was over.", measured(score)},
          {"failed", "", "1 when the team was lost or the time ran out.",
           std::uint64_t{accomplished ? 0U : 1U}},
          {"rooms_entered", "", "Times a robot of the team came into a room.", rooms},
          {"objects_tested", "", "Objects tested.", tested},
          {"objects_dangerous", "", "Objects found dangerous.", dangerous},
          {"objects_stored", "", "Objects put into containers.", stored},
          {"signals", "", "Times a robot called to others.", signals},
          {"alerts", "", "Times a robot alerted its operator.", alerts},
          {"exposures", "", "Times a robot of the team came into an enemy's sight.", exposures},
          {"robots_finished", "", "Robots of the team with nothing more to do.", finished}};
}

}  // namespace tacit
