#include "world_server/world/encounters.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "idl/types/random.h"
#include "world_server/world/physics.h"

namespace tacit {
namespace {

constexpr double kRadius_m = 0.2;
constexpr double kWall_m = 0.05;

struct Meeting {
  Terrain terrain{40.0, 40.0, true, {}, {}};
  std::vector<Encounters::Body> bodies;

  [[nodiscard]] bool near(double way_m, std::size_t body = 0) {
    Encounters(terrain, kWall_m).find(bodies, way_m);
    return bodies[body].near;
  }
};

TEST(Encounters, LeaveOutABodyThatIsAlone) {
  Meeting meeting;
  meeting.bodies = {{{20.0, 20.0}, kRadius_m}, {{25.0, 20.0}, kRadius_m}};
  EXPECT_FALSE(meeting.near(0.5));
}

TEST(Encounters, FindTwoBodiesThatCouldMeetHalfWay) {
  Meeting meeting;
  meeting.bodies = {{{20.0, 20.0}, kRadius_m}, {{21.3, 20.0}, kRadius_m}};
  EXPECT_TRUE(meeting.near(0.5));
  meeting.bodies = {{{20.0, 20.0}, kRadius_m}, {{21.3, 20.0}, kRadius_m}};
  EXPECT_FALSE(meeting.near(0.2));
}

TEST(Encounters, FindABodyThatCouldReachTheTerrain) {
  Meeting meeting;
  meeting.bodies = {{{39.0, 20.0}, kRadius_m}};
  EXPECT_FALSE(meeting.near(0.5));
  EXPECT_TRUE(meeting.near(0.8));
  meeting.bodies = {{{20.0, 20.0}, kRadius_m}};
  meeting.terrain.obstacles = {{{22.0, 20.0}, 1.0}};
  EXPECT_FALSE(meeting.near(0.5));
  EXPECT_TRUE(meeting.near(0.8));
  meeting.bodies = {{{20.0, 20.0}, kRadius_m}};
  meeting.terrain.obstacles.clear();
  meeting.terrain.walls = {{{21.0, 10.0}, {21.0, 30.0}}};
  EXPECT_FALSE(meeting.near(0.5));
  EXPECT_TRUE(meeting.near(0.7));
}

TEST(Encounters, LastALittleLongerThanTheyBegin) {
  Meeting meeting;
  const Encounters::Body right{{21.1, 20.0}, kRadius_m};
  meeting.bodies = {{{20.0, 20.0}, kRadius_m}, right};
  ASSERT_FALSE(meeting.near(0.2));
  meeting.bodies = {{{20.0, 20.0}, kRadius_m, true}, right};
  EXPECT_TRUE(meeting.near(0.2));
  EXPECT_TRUE(meeting.near(0.2, 1));
}

TEST(Encounters, MissNobodyWhoCouldTouchAnother) {
  Stream chance(1, "crowd");
  for (int round = 0; round < 200; ++round) {
    Meeting meeting;
    for (int i = 0; i < 60; ++i) {
      meeting.bodies.push_back({{chance.uniform(0, 40), chance.uniform(0, 40)},
                                chance.uniform(0.1, 1.0),
                                chance.below(2) == 0});
    }
    const double way_m = chance.uniform(0.0, 0.5);
    static_cast<void>(meeting.near(way_m));
    for (const Encounters::Body& a : meeting.bodies) {
      for (const Encounters::Body& b : meeting.bodies) {
        const double gap_m = (a.place_m - b.place_m).norm() - a.radius_m - b.radius_m;
        ASSERT_TRUE(&a == &b || a.near || gap_m > 2.0 * way_m);
      }
    }
  }
}

// Two bodies cross the same field again and again, in Bullet always or only when need be.
struct Twins {
  explicit Twins(const Terrain& terrain)
      : all(terrain, Physics::Care::All), near(terrain, Physics::Care::Near) {}

  void add(const WorldVec& place_m) {
    slots.push_back(all.add(place_m, kRadius_m));
    static_cast<void>(near.add(place_m, kRadius_m));
  }
  void step(std::size_t body, const WorldVec& velocity_mps) {
    all.set_velocity(slots[body], velocity_mps);
    near.set_velocity(slots[body], velocity_mps);
  }
  [[nodiscard]] bool same() const {
    return std::equal(all.contacts().begin(), all.contacts().end(), near.contacts().begin(),
                      near.contacts().end()) &&
           std::all_of(slots.begin(), slots.end(), [this](BodySlot slot) {
             return (all.position(slot) - near.position(slot)).norm() < 1e-9 &&
                    (all.velocity(slot) - near.velocity(slot)).norm() < 1e-9;
           });
  }

  Physics all;
  Physics near;
  std::vector<BodySlot> slots;
};

TEST(Physics, IsTheSameForBodiesInBulletAlwaysOrOnlyWhenNear) {
  Terrain terrain{20.0, 20.0, true, {{{10.0, 10.0}, 1.0}}, {{{4.0, 2.0}, {4.0, 8.0}}}};
  int contacts = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Twins twins(terrain);
    Stream chance(seed, "ways");
    twins.add({2.0, 2.0});
    twins.add({15.0, 15.0});
    std::vector<WorldVec> ways(2);
    for (int tick = 0; tick < 300; ++tick) {
      for (std::size_t body = 0; body < 2; ++body) {
        if (tick % 40 == 0) {
          const Heading heading = Heading::from_rad(chance.uniform(-kPi, kPi));
          ways[body] = chance.uniform(0.1, 0.5) * WorldVec{heading.cos, heading.sin};
        }
        twins.step(body, ways[body]);
      }
      twins.all.step(1.0, 3);
      twins.near.step(1.0, 3);
      contacts += static_cast<int>(!twins.all.contacts().empty());
      ASSERT_TRUE(twins.same()) << "seed " << seed << " tick " << tick;
    }
  }
  EXPECT_GT(contacts, 500);
}

TEST(Physics, LetsNobodyPushAPinnedBody) {
  for (const Physics::Care care : {Physics::Care::All, Physics::Care::Near}) {
    Physics physics({40.0, 40.0, true, {}, {}}, care);
    const BodySlot pinned = physics.add({20.0, 20.0}, kRadius_m);
    const BodySlot other = physics.add({19.0, 20.0}, kRadius_m);
    physics.set_velocity(pinned, {0.5, 0.0});
    physics.pin(pinned);
    bool touched = false;
    for (int tick = 0; tick < 10; ++tick) {
      physics.set_velocity(other, {0.4, 0.0});
      physics.step(1.0, 3);
      touched = touched || !physics.contacts().empty();
      ASSERT_EQ(physics.position(pinned), (WorldVec{20.0, 20.0}));
    }
    EXPECT_TRUE(touched);
    EXPECT_LT(physics.position(other).x(), 19.8);
  }
}

TEST(Physics, LetsAnUnpinnedBodyGoOnFromStandstill) {
  for (const Physics::Care care : {Physics::Care::All, Physics::Care::Near}) {
    Physics physics({40.0, 40.0, true, {}, {}}, care);
    const BodySlot body = physics.add({20.0, 20.0}, kRadius_m);
    physics.set_velocity(body, {0.5, 0.0});
    physics.pin(body);
    physics.step(1.0, 3);
    physics.unpin(body);
    physics.step(1.0, 3);
    EXPECT_EQ(physics.position(body), (WorldVec{20.0, 20.0}));
    for (int tick = 0; tick < 50; ++tick) {
      physics.set_velocity(body, {0.5, 0.0});
      physics.step(1.0, 3);
    }
    // The border stops it.
    EXPECT_NEAR(physics.position(body).x(), 40.0 - kRadius_m, 0.17);
    ASSERT_EQ(physics.contacts().size(), 1u);
  }
}

}  // namespace
}  // namespace tacit
