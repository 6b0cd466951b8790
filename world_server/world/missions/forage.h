#pragma once

#include <cstdint>
#include <vector>

#include "world_server/world/missions/hunters.h"
#include "world_server/world/missions/mines.h"
#include "world_server/world/missions/mission.h"
#include "world_server/world/missions/mud.h"

namespace tacit {

/// Bring mines to a base, under hazards and hunters (paper, section 3). It is over when every mine
/// is stored, when nobody is left to help, or at the cap.
class Forage final : public Mission {
 public:
  /// Throws ConfigError when the mines cannot be laid.
  explicit Forage(Stage& stage);

  void set_out(Stage& stage) override;
  void settle(Stage& stage) override;
  void conclude(Stage& stage) override;
  [[nodiscard]] bool over() const override { return over_; }
  void add_to(Digest& digest, const Stage& stage) const override;
  void show(WorldView& out) const override;

 private:
  void get_stuck(Stage& stage);
  void lose_mines(Stage& stage);
  void aid(Stage& stage);
  [[nodiscard]] std::size_t helper_of(std::size_t robot, const Stage& stage) const;
  void pick_up(Stage& stage);
  void put_down(Stage& stage);
  void lay_down(std::size_t robot, Stage& stage);
  void store(std::size_t robot, Stage& stage);
  void end(Stage& stage, Verdict verdict, Tick score_ticks);

  ReachConfig reach_;
  Tick cap_ticks_;
  Mines mines_;
  Mud mud_;
  Hunters hunters_;
  bool over_ = false;
  std::vector<std::uint8_t> was_able_;  ///< Per robot: when the step began.
};

}  // namespace tacit
