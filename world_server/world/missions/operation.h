#pragma once

#include <cstdint>
#include <vector>

#include "world_server/world/missions/doorways.h"
#include "world_server/world/missions/exposure.h"
#include "world_server/world/missions/mission.h"
#include "world_server/world/missions/objects.h"
#include "world_server/world/missions/operator_desk.h"
#include "world_server/world/missions/signals.h"
#include "world_server/world/missions/visits.h"

namespace tacit {

/// Whatever a mission file says, on a map (paper, section 4): a team, at times with sentries or
/// bystanders about, goes through rooms and hallways, finds, tests and carries objects, marks
/// doorways and calls to one another. It is over when every able robot of the team has finished, or
/// when none is able.
class Operation final : public Mission {
 public:
  Operation(Stage& stage, const MapPlan& plan);

  void set_out(Stage& stage) override;
  void settle(Stage& stage) override;
  void conclude(Stage& stage) override;
  void perceive(Stage& stage) override;
  bool hear(const Control& control) override { return desk_.hear(control); }
  [[nodiscard]] bool over() const override { return over_; }
  void add_to(Digest& digest, const Stage& stage) const override;
  void show(WorldView& out) const override { objects_.show(out); }

 private:
  [[nodiscard]] bool in_team(std::size_t robot) const { return robot < team_; }
  [[nodiscard]] bool enemies(std::size_t a, std::size_t b) const;
  [[nodiscard]] Reach reach(std::size_t robot, double reach_m, const Stage& stage);
  void begin(Stage& stage);
  void intercept(Stage& stage);
  void intercept(std::size_t robot, Stage& stage);
  void act(std::size_t robot, Stage& stage);
  void pick_up(std::size_t robot, Stage& stage);
  void put_down(std::size_t robot, Stage& stage);
  void lay_down(std::size_t robot, Stage& stage);
  void test(std::size_t robot, Stage& stage);
  void mark(std::size_t robot, bool marked, Stage& stage);
  void alert(std::size_t robot, Stage& stage);
  void finish(std::size_t robot, Stage& stage);
  void finish_all(std::size_t robot, Stage& stage);
  void end(Stage& stage, Verdict verdict);

  OperationReachConfig reach_;
  double doorway_range_m_;
  std::size_t team_;  ///< Robots of it; the others are the extras.
  bool hostile_;      ///< The extras are enemies.
  LineOfSight sight_;
  Objects objects_;
  Doorways doorways_;
  Visits visits_;
  Signals signals_;
  Exposure exposure_;
  OperatorDesk desk_;
  std::vector<std::uint8_t> finished_;  ///< Per robot.
  bool over_ = false;
};

}  // namespace tacit
