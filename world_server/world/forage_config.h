#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "idl/types/parameters.h"

namespace tacit {

struct AreaConfig;

struct BaseConfig {
  double x_m = 30.0;
  double y_m = 30.0;
  double radius_m = 0.5;
};

struct MineConfig {
  std::int64_t count = 20;
  std::string layout = "scattered";  ///< "scattered", "clusters" or "ring".
  std::int64_t clusters = 4;
  double cluster_radius_m = 4.0;
  double ring_inset_m = 4.0;
  double keep_from_base_m = 8.0;
  double radius_m = 0.25;
  std::int64_t seed = 0;
  std::vector<std::vector<double>> places;  ///< Rows of x, y.
};

struct MudConfig {
  double per_tick = 5e-5;
};

struct HunterConfig {
  std::int64_t count = 1;
  double speed_mps = 0.25;
  double radius_m = 0.2;
  double contact_m = 0.5;
  std::int64_t min_wait_ticks = 500;
  std::int64_t max_wait_ticks = 1500;
  double avoid_reach_m = 1.2;
  double avoid_margin_m = 0.3;
};

/// What a robot can do with what is how near, centre to centre.
struct ReachConfig {
  double pick_up_m = 0.5;
  double drop_m = 1.0;
  double intercept_m = 1.0;
  double aid_m = 0.5;
  bool revival_needs_aid = true;
};

struct ForageConfig {
  BaseConfig base;
  MineConfig mines;
  MudConfig mud;
  HunterConfig hunters;
  ReachConfig reach;
  std::int64_t cap_ticks = 1'000'000;
};

/// The foraging part of `describe` and `check` of a `WorldConfig`; places are to lie in `area`.
void describe(ForageConfig& config, ParameterVisitor& visitor);
void check(const ForageConfig& config, const AreaConfig& area);

}  // namespace tacit
