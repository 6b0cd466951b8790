#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "idl/overlay/plan.h"
#include "idl/types/ids.h"
#include "idl/types/percept.h"
#include "idl/types/world_view.h"
#include "world_server/world/digest.h"
#include "world_server/world/missions/reach.h"
#include "world_server/world/sensing/senses.h"

namespace tacit {

/// Every object of a map, numbered from 1 in its order: it lies somewhere, is held by a robot, or
/// is stored in a container for good. Nothing bumps into one; nobody sees one that does not lie.
///
/// What a robot does, it does to the object in reach whose rim is nearest, the lowest number on a
/// tie; 0 stands for none. A colour that is not given stands for any.
class Objects {
 public:
  struct Test {
    ObjectId object;
    Finding finding = Finding::None;
  };

  /// `robots` may hold one each.
  Objects(const MapPlan& plan, std::size_t robots);

  /// Gives `robot`, which holds nothing, a movable object.
  ObjectId take(std::size_t robot, const Reach& reach, std::optional<Colour> colour);
  [[nodiscard]] ObjectId container(const Reach& reach) const;
  /// Lays what `robot` holds down at `place_m`.
  ObjectId put_down(std::size_t robot, const WorldVec& place_m);
  /// Stores what `robot` holds.
  ObjectId store(std::size_t robot);
  /// A movable object is dangerous, another one is not (MissionLab). It is grey from then on, and
  /// one that is grey is not tested again unless asked for by that colour.
  Test test(const Reach& reach, std::optional<Colour> colour);

  [[nodiscard]] Colour held_colour(std::size_t robot) const;
  /// Those that lie, in order.
  [[nodiscard]] std::span<const Landmark> lying() const { return lying_; }
  void show(WorldView& out) const;
  void add_to(Digest& digest) const;

 private:
  enum class State : std::uint8_t { Lying, Held, Stored };
  struct Object {
    WorldVec place_m;  ///< Where it lies or lay last.
    double radius_m = 0.0;
    Mobility mobility = Mobility::Fixed;
    Colour colour = Colour::Brown;
    State state = State::Lying;
  };
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  template <class Fits>
  [[nodiscard]] std::size_t nearest(const Reach& reach, Fits fits) const;
  ObjectId release(std::size_t robot, State state);
  /// Brings the list of what lies up to date.
  void survey();

  std::vector<Object> objects_;
  std::vector<std::size_t> held_;  ///< Per robot.
  std::vector<Landmark> lying_;
};

}  // namespace tacit
