#include "console/metrics/forage.h"

namespace tacit {
namespace {

struct Count {
  Forage& forage;

  void operator()(const ForageBegun& e) const { forage.mines = e.mines; }
  void operator()(const MineStored& /*e*/) const { ++forage.stored; }
  void operator()(const MineDropped& /*e*/) const { ++forage.dropped; }
  void operator()(const RobotDisabled& e) const {
    ++(e.by == Mishap::Mud ? forage.stuck : forage.struck);
  }
  void operator()(const RobotRevived& /*e*/) const { ++forage.revived; }
  void operator()(const EnemyCreated& e) const {
    forage.hunters += e.kind == EnemyKind::Hunter ? 1 : 0;
  }
  void operator()(const EnemyIntercepted& e) const {
    forage.intercepted += e.kind == EnemyKind::Hunter ? 1 : 0;
  }
  void operator()(const MissionOver& e) const { forage.end = e; }
  template <class Other>
  void operator()(const Other& /*e*/) const {}
};

std::optional<double> score(const std::optional<MissionOver>& end) {
  return end ? std::optional(static_cast<double>(end->score_ticks)) : std::nullopt;
}

}  // namespace

void Forage::add(const Event& event) { std::visit(Count{*this}, event.what); }

std::vector<Metric> Forage::metrics() const {
  if (!mines) {
    return {};
  }
  const std::uint64_t failed = end && end->verdict != Verdict::Accomplished ? 1 : 0;
  return {{"score_ticks", "", "Ticks until the last mine was stored; the cap when it never was.",
           measured(score(end))},
          {"failed", "", "1 when the team was lost or the time ran out.", failed},
          {"mines", "", "Mines to be stored.", *mines},
          {"mines_stored", "", "Mines stored.", stored},
          {"mines_dropped", "", "Times a mine was put down or lost outside the base.", dropped},
          {"robots_stuck", "", "Times a robot was disabled by the terrain.", stuck},
          {"robots_struck", "", "Times a robot was disabled by a hunter.", struck},
          {"robots_revived", "", "Times a disabled robot was got going again.", revived},
          {"hunters_created", "", "Times a hunter came out of hiding.", hunters},
          {"hunters_intercepted", "", "Hunters destroyed by a robot.", intercepted}};
}

}  // namespace tacit
