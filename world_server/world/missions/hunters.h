#pragma once

#include <vector>

#include "world_server/world/digest.h"
#include "world_server/world/enemies/hunter_mind.h"
#include "world_server/world/stage.h"

namespace tacit {

/// Mobile enemies that hide at the rim, come out to disable robots, and retreat to another place at
/// the rim (paper, section 3). While one retreats it harms nobody.
class Hunters {
 public:
  explicit Hunters(const Stage& stage);

  /// Brings out those whose waiting time is over.
  void come_out(Stage& stage);
  /// Hunting ones go for the nearest able robot, retreating ones for their hiding place.
  void drive(Stage& stage);
  /// After the motion: some are intercepted, some disable a robot, some are back in hiding.
  void settle(Stage& stage);
  void add_to(Digest& digest) const;

 private:
  enum class Doing : std::uint8_t { Hiding, Hunting, Retreating };
  struct Hunter {
    Stream chance;
    Wander wander;
    Doing doing = Doing::Hiding;
    WorldVec hide_m;  ///< Where it hides or is going to.
    Tick out_at = 0;  ///< While hiding: the first tick of its coming out.
    EnemyId id;       ///< While outside.
  };
  void choose_hiding_place(const Terrain& terrain, Hunter& hunter) const;
  void hide(Hunter& hunter, Tick from) const;
  void intercept(Stage& stage);
  [[nodiscard]] bool intercepted(std::size_t k, Stage& stage) const;
  void strike(Stage& stage);
  void touch(std::size_t k, Stage& stage);
  [[nodiscard]] bool arrived(std::size_t k, const Stage& stage) const;
  [[nodiscard]] Hunter& outside(std::size_t k) { return hunters_[outside_[k]]; }
  [[nodiscard]] const Hunter& outside(std::size_t k) const { return hunters_[outside_[k]]; }

  HunterConfig config_;
  double intercept_m_;
  double inset_m_;
  double everywhere_m_;  ///< No two places of the area are further apart.
  HunterMind mind_;
  std::uint32_t created_ = 0;
  std::vector<Hunter> hunters_;
  std::vector<std::size_t> outside_;  ///< Hunter number of each of the stage's visitors.
  std::vector<std::uint8_t> gone_;
};

}  // namespace tacit
