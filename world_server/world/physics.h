#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "idl/types/frames.h"
#include "world_server/world/terrain.h"

namespace tacit {

/// A moving body's slot. Slots of removed bodies are used again.
using BodySlot = std::uint32_t;

/// What one end of a contact is.
enum class ContactSide : std::uint8_t { Mover, Obstacle, Wall };

/// A moving body touched something during the last step. `mover` is the lower slot when both move.
struct Contact {
  BodySlot mover = 0;
  ContactSide with = ContactSide::Obstacle;
  std::uint32_t other = 0;  ///< Slot, or index into the terrain's obstacles or walls.
  friend auto operator<=>(const Contact&, const Contact&) = default;
};

/// Rigid discs in the plane, in a Bullet world.
///
/// A disc is a sphere whose centre stays in the plane z = 0: two such spheres touch exactly when
/// the discs do, and sphere against sphere is Bullet's quickest and exact test. Contacts are
/// frictionless, so they never turn a body; heading is not Bullet's concern.
///
/// A body that nothing is near to goes where its velocity takes it, as Bullet would move it but
/// without Bullet's cost.
class Physics {
 public:
  /// Which bodies are left to Bullet.
  enum class Care : std::uint8_t {
    All,
    Near,  ///< Those that could touch something in the step.
  };

  explicit Physics(const Terrain& terrain, Care care = Care::Near);
  ~Physics();
  Physics(Physics&&) noexcept;
  Physics& operator=(Physics&&) noexcept;

  [[nodiscard]] BodySlot add(const WorldVec& position_m, double radius_m);
  void remove(BodySlot slot);

  void set_velocity(BodySlot slot, const WorldVec& velocity_mps);
  [[nodiscard]] WorldVec position(BodySlot slot) const;
  [[nodiscard]] WorldVec velocity(BodySlot slot) const;

  /// Stops the body where it is; nothing moves it until `unpin`, which leaves it standing.
  void pin(BodySlot slot);
  void unpin(BodySlot slot);

  /// Moves every body by its velocity for `duration_s`, in `substeps` equal parts, and resolves
  /// contacts in each.
  void step(double duration_s, std::int64_t substeps = 1);

  /// Contacts in any part of the last step, sorted, each once; valid until the next step.
  [[nodiscard]] std::span<const Contact> contacts() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
