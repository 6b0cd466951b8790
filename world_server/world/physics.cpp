#include "world_server/world/physics.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <vector>

#include "world_server/world/encounters.h"

namespace tacit {
namespace {

constexpr double kMass = 1.0;
constexpr double kWallHalfThickness_m = 0.05;
constexpr double kBorderHalfThickness_m = 1.0;
constexpr double kWallHalfHeight_m = 1.0;

// Where a body came from, packed into Bullet's user index.
struct Tag {
  static int mover(BodySlot slot) { return static_cast<int>(slot) * 4; }
  static int obstacle(std::size_t index) { return static_cast<int>(index) * 4 + 1; }
  static int wall(std::size_t index) { return static_cast<int>(index) * 4 + 2; }
  static ContactSide side(int tag) { return static_cast<ContactSide>(tag & 3); }
  static std::uint32_t index(int tag) { return static_cast<std::uint32_t>(tag) >> 2; }
};

btVector3 in_plane(const WorldVec& v) { return {v.x(), v.y(), 0.0}; }

std::unique_ptr<btRigidBody> make_body(double mass, btCollisionShape* shape,
                                       const btVector3& centre, int tag) {
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape);
  info.m_startWorldTransform.setOrigin(centre);
  info.m_friction = 0.0;
  info.m_restitution = 0.0;
  auto body = std::make_unique<btRigidBody>(info);
  body->setUserIndex(tag);
  return body;
}

}  // namespace

class Physics::Impl {
 public:
  Impl(const Terrain& terrain, Care care)
      : care_(care), encounters_(terrain, kWallHalfThickness_m) {
    world_.setGravity({0, 0, 0});
    // Static bodies never move; without this every step recomputes their boxes.
    world_.setForceUpdateAllAabbs(false);
    for (std::size_t i = 0; i < terrain.obstacles.size(); ++i) {
      const Disc& disc = terrain.obstacles[i];
      add_static(sphere(disc.radius_m), in_plane(disc.centre_m), 0.0, Tag::obstacle(i));
    }
    for (std::size_t i = 0; i < terrain.walls.size(); ++i) {
      add_wall(terrain.walls[i], i);
    }
    if (terrain.border_walls) {
      add_border(terrain);
    }
  }

  ~Impl() {
    for (const auto& body : statics_) {
      world_.removeRigidBody(body.get());
    }
    for (Mover& mover : movers_) {
      withdraw(mover);
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  BodySlot add(const WorldVec& position_m, double radius_m) {
    const BodySlot slot = take_slot();
    auto body = make_body(kMass, sphere(radius_m), in_plane(position_m), Tag::mover(slot));
    body->setLinearFactor({1, 1, 0});
    body->setAngularFactor(0.0);
    body->setActivationState(DISABLE_DEACTIVATION);
    // Nothing turns a body, so there is no gyroscopic torque to work out.
    body->setFlags(0);
    movers_[slot] = {std::move(body), radius_m};
    if (care_ == Care::All) {
      engage(movers_[slot]);
    }
    return slot;
  }

  void remove(BodySlot slot) {
    withdraw(movers_[slot]);
    movers_[slot].body.reset();
    free_.push_back(slot);
  }

  // Without mass a body is to Bullet what a wall is. Bullet must be told anew what it has.
  void set_mass(BodySlot slot, double mass) {
    withdraw(movers_[slot]);
    body(slot).setLinearVelocity({0, 0, 0});
    body(slot).setMassProps(mass, {0, 0, 0});
    if (care_ == Care::All) {
      engage(movers_[slot]);
    }
  }

  void step(double duration_s, std::int64_t substeps) {
    contacts_.clear();
    const double part_s = duration_s / static_cast<double>(substeps);
    if (care_ == Care::Near) {
      look_round(duration_s);
      drift(part_s, substeps);
    }
    for (std::int64_t i = 0; i < substeps && engaged_ > 0; ++i) {
      world_.stepSimulation(part_s, 0);
      collect_contacts();
    }
    std::sort(contacts_.begin(), contacts_.end());
    contacts_.erase(std::unique(contacts_.begin(), contacts_.end()), contacts_.end());
  }

  [[nodiscard]] btRigidBody& body(BodySlot slot) const {
    assert(slot < movers_.size() && movers_[slot].body);
    return *movers_[slot].body;
  }
  [[nodiscard]] std::span<const Contact> contacts() const { return contacts_; }

 private:
  struct Mover {
    std::unique_ptr<btRigidBody> body;  ///< None in a free slot.
    double radius_m = 0.0;
    bool engaged = false;  ///< Bullet has it.
  };

  void engage(Mover& mover) {
    if (mover.engaged) return;
    mover.body->setInterpolationWorldTransform(mover.body->getWorldTransform());
    world_.addRigidBody(mover.body.get());
    mover.engaged = true;
    ++engaged_;
  }

  void withdraw(Mover& mover) {
    if (!mover.engaged) return;
    world_.removeRigidBody(mover.body.get());
    mover.engaged = false;
    --engaged_;
  }

  // A body that is pushed goes no faster than who pushes it, so the fastest tells for all.
  void look_round(double duration_s) {
    bodies_.clear();
    double fastest2 = 0.0;
    for (const Mover& mover : movers_) {
      if (mover.body) {
        const btVector3& p = mover.body->getWorldTransform().getOrigin();
        bodies_.push_back({{p.x(), p.y()}, mover.radius_m, mover.engaged});
        fastest2 = std::max(fastest2, mover.body->getLinearVelocity().length2());
      }
    }
    encounters_.find(bodies_, std::sqrt(fastest2) * duration_s);
    auto body = bodies_.begin();
    for (Mover& mover : movers_) {
      if (mover.body) {
        body->near ? engage(mover) : withdraw(mover);
        ++body;
      }
    }
  }

  // The same sums as Bullet's.
  void drift(double part_s, std::int64_t substeps) {
    for (Mover& mover : movers_) {
      if (mover.body && !mover.engaged) {
        btVector3& place = mover.body->getWorldTransform().getOrigin();
        for (std::int64_t i = 0; i < substeps; ++i) {
          place += mover.body->getLinearVelocity() * part_s;
        }
      }
    }
  }

  // Shapes are shared by radius, as Bullet intends.
  btCollisionShape* sphere(double radius_m) {
    auto& shape = spheres_[radius_m];
    if (!shape) {
      shape = std::make_unique<btSphereShape>(radius_m);
    }
    return shape.get();
  }

  BodySlot take_slot() {
    if (free_.empty()) {
      movers_.emplace_back();
      return static_cast<BodySlot>(movers_.size() - 1);
    }
    const BodySlot slot = free_.back();
    free_.pop_back();
    return slot;
  }

  void add_static(btCollisionShape* shape, const btVector3& centre, double angle_rad, int tag) {
    auto body = make_body(0.0, shape, centre, tag);
    // The half angle's sine and cosine are ours, so that walls lie the same on every machine.
    const SinCos half = sin_cos(0.5 * angle_rad);
    body->getWorldTransform().setRotation(btQuaternion(0, 0, half.sin, half.cos));
    world_.addRigidBody(body.get());
    statics_.push_back(std::move(body));
  }

  btCollisionShape* box(double half_length_m, double half_thickness_m) {
    boxes_.push_back(std::make_unique<btBoxShape>(
        btVector3(half_length_m, half_thickness_m, kWallHalfHeight_m)));
    return boxes_.back().get();
  }

  void add_wall(const Wall& wall, std::size_t index) {
    const WorldVec along = wall.to_m - wall.from_m;
    add_static(box(0.5 * along.norm(), kWallHalfThickness_m), in_plane(wall.from_m + 0.5 * along),
               arc_tangent(along.y(), along.x()), Tag::wall(index));
  }

  void add_border(const Terrain& terrain) {
    const double t = kBorderHalfThickness_m;
    const double w = 0.5 * terrain.width_m;
    const double h = 0.5 * terrain.height_m;
    const std::size_t first = terrain.walls.size();
    add_static(box(w + 2 * t, t), {w, -t, 0}, 0.0, Tag::wall(first));
    add_static(box(w + 2 * t, t), {w, 2 * h + t, 0}, 0.0, Tag::wall(first + 1));
    add_static(box(t, h + 2 * t), {-t, h, 0}, 0.0, Tag::wall(first + 2));
    add_static(box(t, h + 2 * t), {2 * w + t, h, 0}, 0.0, Tag::wall(first + 3));
  }

  void collect_contacts() {
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      if (manifold.getNumContacts() > 0) {
        contacts_.push_back(
            contact(manifold.getBody0()->getUserIndex(), manifold.getBody1()->getUserIndex()));
      }
    }
  }

  static Contact contact(int a, int b) {
    const bool a_first = Tag::side(a) < Tag::side(b) ||
                         (Tag::side(a) == Tag::side(b) && Tag::index(a) < Tag::index(b));
    const int mover = a_first ? a : b;
    const int other = a_first ? b : a;
    return {Tag::index(mover), Tag::side(other), Tag::index(other)};
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::map<double, std::unique_ptr<btCollisionShape>> spheres_;
  std::vector<std::unique_ptr<btCollisionShape>> boxes_;
  std::vector<std::unique_ptr<btRigidBody>> statics_;
  std::vector<Mover> movers_;
  std::vector<BodySlot> free_;
  std::vector<Contact> contacts_;
  Care care_;
  std::size_t engaged_ = 0;
  Encounters encounters_;
  std::vector<Encounters::Body> bodies_;
};

Physics::Physics(const Terrain& terrain, Care care)
    : impl_(std::make_unique<Impl>(terrain, care)) {}
Physics::~Physics() = default;
Physics::Physics(Physics&&) noexcept = default;
Physics& Physics::operator=(Physics&&) noexcept = default;

BodySlot Physics::add(const WorldVec& position_m, double radius_m) {
  return impl_->add(position_m, radius_m);
}

void Physics::remove(BodySlot slot) { impl_->remove(slot); }

void Physics::set_velocity(BodySlot slot, const WorldVec& velocity_mps) {
  impl_->body(slot).setLinearVelocity(in_plane(velocity_mps));
}

WorldVec Physics::position(BodySlot slot) const {
  const btVector3& p = impl_->body(slot).getWorldTransform().getOrigin();
  return {p.x(), p.y()};
}

WorldVec Physics::velocity(BodySlot slot) const {
  const btVector3& v = impl_->body(slot).getLinearVelocity();
  return {v.x(), v.y()};
}

void Physics::pin(BodySlot slot) { impl_->set_mass(slot, 0.0); }
void Physics::unpin(BodySlot slot) { impl_->set_mass(slot, kMass); }

void Physics::step(double duration_s, std::int64_t substeps) { impl_->step(duration_s, substeps); }

std::span<const Contact> Physics::contacts() const { return impl_->contacts(); }

}  // namespace tacit
