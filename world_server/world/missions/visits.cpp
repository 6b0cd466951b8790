#include "world_server/world/missions/visits.h"

#include <algorithm>

#include "world_server/world/missions/operation_map.h"

namespace tacit {

Visits::Visits(const MapPlan& plan, double reach_m, const Stage& stage)
    : sites_(plan), reached_(stage.robots() * plan.points.size(), 0) {
  for (const PlanPoint& point : plan.points) {
    points_.push_back({place_of(point.at), std::max(reach_m, point.radius_m)});
  }
  for (std::size_t i = 0; i < stage.robots(); ++i) {
    spots_.push_back(sites_.at(stage.place_m(i)));
  }
}

void Visits::begin(Stage& stage) {
  for (std::size_t i = 0; i < spots_.size(); ++i) {
    stage.report(SiteEntered{stage.id_of(i), spots_[i].site, spots_[i].number});
  }
  reach_points(stage);
}

void Visits::follow(Stage& stage) {
  for (std::size_t i = 0; i < spots_.size(); ++i) {
    const Spot now = sites_.at(stage.place_m(i));
    if (now != spots_[i]) {
      spots_[i] = now;
      stage.report(SiteEntered{stage.id_of(i), now.site, now.number});
    }
  }
  reach_points(stage);
}

void Visits::reach_points(Stage& stage) {
  for (std::size_t i = 0; i < spots_.size(); ++i) {
    for (std::size_t k = 0; k < points_.size(); ++k) {
      std::uint8_t& reached = reached_[i * points_.size() + k];
      const double away2 = (points_[k].place_m - stage.place_m(i)).squared_norm();
      if (reached == 0 && away2 <= points_[k].reach_m * points_[k].reach_m) {
        reached = 1;
        stage.report(PointReached{stage.id_of(i), static_cast<std::uint32_t>(k + 1)});
      }
    }
  }
}

void Visits::add_to(Digest& digest) const {
  for (const std::uint8_t reached : reached_) {
    digest.add(static_cast<std::uint64_t>(reached));
  }
}

}  // namespace tacit
