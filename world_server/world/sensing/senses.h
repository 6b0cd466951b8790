#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "idl/types/percept.h"
#include "idl/types/random.h"
#include "world_server/world/sensing/body_grid.h"
#include "world_server/world/sensing/line_of_sight.h"
#include "world_server/world/sensing/near_map.h"
#include "world_server/world/terrain.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// What a thing looks like to whoever recognises it.
struct Look {
  Kind kind = Kind::Target;
  Colour colour = Colour::White;
  double radius_m = 0.0;
};

/// One thing that stays where it is.
struct Landmark {
  WorldVec place_m;
  Look look;
};

/// Many things that look alike; none without a grid.
struct Things {
  const BodyGrid* grid = nullptr;
  Look look;
};

/// What the sensors meet. Bodies are robots first, in order of id, then visitors.
struct Scene {
  std::span<const WorldVec> places_m;  ///< Of the bodies.
  std::span<const Heading> headings;   ///< Of the robots.
  std::span<const Look> looks;         ///< Of the bodies.
  const BodyGrid* grid = nullptr;      ///< Over `places_m`.
  std::span<const Landmark> landmarks;
  Things things;
};

/// Turns the world's state into what each robot's sensors deliver.
///
/// Things are recognised within range, field of view and line of sight; landmarks count as seen
/// like any other thing. Obstacles are ranged when their surface is near enough; they do not
/// hide one another. Robots and enemies are too small to hide anything.
class Senses {
 public:
  /// Keeps a reference to `terrain`.
  Senses(const WorldConfig& config, const Terrain& terrain, std::uint64_t seed);

  /// Fills in `sightings` and `obstacles` of the robot with index `robot`.
  void sense(const Scene& scene, std::size_t robot, Percept& out);

 private:
  struct Eye {
    WorldVec place_m;
    Heading heading;
    bool open = false;  ///< It recognises whatever is in range.
  };
  /// Takes in the thing at `offset`, which is in range, unless it is out of view or hidden.
  void see(const Eye& eye, const WorldVec& offset, const Look& as, Percept& out);
  /// Whether the thing at `offset`, or `seen` from the body, is in view and not hidden.
  [[nodiscard]] bool recognisable(const WorldVec& offset, const BodyVec& seen) const;
  void see_bodies(const Scene& scene, std::size_t robot, const Eye& eye, Percept& out);
  void see_things(const Things& things, const Eye& eye, Percept& out);
  void range_obstacles(const Eye& eye, Percept& out) const;
  void range_border(const Eye& eye, Percept& out) const;
  void blur(std::size_t robot, Percept& out);

  SightConfig sight_;
  double range2_m2_;
  double half_view_cos_;
  bool panoramic_;
  const Terrain* terrain_;
  NearMap near_;
  LineOfSight line_of_sight_;
  std::vector<double> ranges_;  ///< Scratch, kept for its memory.
  std::vector<Stream> noise_;   ///< One per robot; empty without noise.
};

}  // namespace tacit
