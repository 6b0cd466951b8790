#include "world_server/world/missions/mine_field.h"

#include <algorithm>
#include <optional>
#include <string>

#include "idl/types/config_error.h"
#include "idl/types/random.h"

namespace tacit {
namespace {

constexpr double kFromBorder_m = 1.0;
constexpr double kApart_m = 0.5;
constexpr int kTries = 1000;

class MineField {
 public:
  MineField(const WorldConfig& config, const Terrain& terrain, std::uint64_t seed)
      : config_(&config),
        terrain_(&terrain),
        rules_(config.forage.mines),
        base_m_(config.forage.base.x_m, config.forage.base.y_m),
        chance_(rules_.seed != 0 ? static_cast<std::uint64_t>(rules_.seed) : seed, "mine field") {}

  std::vector<WorldVec> lay() {
    place_given();
    if (rules_.layout == "clusters") {
      choose_clusters();
    }
    for (std::int64_t i = 0; i < rules_.count; ++i) {
      mines_.push_back(found([this, i] { return draw(i); },
                             [this](const WorldVec& p) { return has_room(p) && apart(p); }));
    }
    return std::move(mines_);
  }

 private:
  void place_given() {
    for (const auto& row : rules_.places) {
      const WorldVec place{row[0], row[1]};
      if (clearance_m(*terrain_, place) < 0.0) {
        throw ConfigError("[mines] places holds a point in an obstacle; wanted all in the open");
      }
      mines_.push_back(place);
    }
  }

  void choose_clusters() {
    for (std::int64_t i = 0; i < rules_.clusters; ++i) {
      centres_.push_back(
          found([this] { return anywhere(); }, [this](const WorldVec& p) { return has_room(p); }));
    }
  }

  /// The first of `draw`'s places that fits.
  template <class Draw, class Fits>
  WorldVec found(Draw draw, Fits fits) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const WorldVec place = draw();
      if (fits(place)) {
        return place;
      }
    }
    refuse();
  }

  WorldVec draw(std::int64_t mine) {
    if (rules_.layout == "ring") {
      return rim_place(*terrain_, rules_.ring_inset_m, chance_.uniform());
    }
    return rules_.layout == "clusters"
               ? in_cluster(centres_[static_cast<std::size_t>(mine % rules_.clusters)])
               : anywhere();
  }

  WorldVec anywhere() {
    const double x = chance_.uniform(kFromBorder_m, terrain_->width_m - kFromBorder_m);
    const double y = chance_.uniform(kFromBorder_m, terrain_->height_m - kFromBorder_m);
    return {x, y};
  }

  // The root spreads them evenly over the disc.
  WorldVec in_cluster(const WorldVec& centre) {
    const double range_m = rules_.cluster_radius_m * std::sqrt(chance_.uniform());
    const Heading side = Heading::from_rad(chance_.uniform(-kPi, kPi));
    return centre + range_m * WorldVec{side.cos, side.sin};
  }

  [[nodiscard]] bool has_room(const WorldVec& p) const {
    return from_border_m(p) >= border_m() && (p - base_m_).norm() >= rules_.keep_from_base_m &&
           clearance_m(*terrain_, p) >= mine_clearance_m(*config_);
  }

  [[nodiscard]] double from_border_m(const WorldVec& p) const {
    return std::min({p.x(), p.y(), terrain_->width_m - p.x(), terrain_->height_m - p.y()});
  }

  [[nodiscard]] double border_m() const { return rules_.layout == "ring" ? 0.0 : kFromBorder_m; }

  [[nodiscard]] bool apart(const WorldVec& p) const {
    return std::none_of(mines_.begin(), mines_.end(),
                        [&p](const WorldVec& other) { return (other - p).norm() < kApart_m; });
  }

  [[noreturn]] void refuse() const {
    throw ConfigError("[mines] count = " + std::to_string(rules_.count) + ": no room for mine " +
                      std::to_string(mines_.size() + 1) + " in the layout \"" + rules_.layout +
                      "\"; wanted fewer mines or obstacles, a wider layout or a smaller "
                      "keep_from_base_m");
  }

  const WorldConfig* config_;
  const Terrain* terrain_;
  const MineConfig& rules_;
  WorldVec base_m_;
  Stream chance_;
  std::vector<WorldVec> centres_;
  std::vector<WorldVec> mines_;
};

}  // namespace

std::vector<WorldVec> lay_mines(const WorldConfig& config, const Terrain& terrain,
                                std::uint64_t seed) {
  return MineField(config, terrain, seed).lay();
}

}  // namespace tacit
