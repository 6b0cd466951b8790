#include <gtest/gtest.h>

#include "tests/world/operation_field.h"

namespace tacit {
namespace {

// Object 1 lies 0.9 m east of robot 1, who stands in the hallway; none has another colour.
Field with_object(const std::string& kind, const std::string& more = "") {
  return Field(on_floor({{3.0, 5.0, 0.0}}, "OBJECT 3.9 5 0.3 " + kind + "\n" + more));
}

TEST(Object, IsSeenByItsColourAndSize) {
  const Field field = with_object("Movable brown");
  ASSERT_EQ(field.percept(1).sightings.size(), 1U);
  const Sighting& seen = field.percept(1).sightings[0];
  EXPECT_EQ(seen.kind, Kind::Object);
  EXPECT_EQ(seen.colour, Colour::Brown);
  EXPECT_EQ(seen.radius_m, 0.3);
  EXPECT_NEAR(seen.offset_m.x(), 0.9, 1e-12);
  EXPECT_NEAR(seen.offset_m.y(), 0.0, 1e-12);
}

TEST(Object, IsHiddenByWallsAndSeenThroughADoor) {
  const Field field(
      on_floor({{6.0, 5.0, 0.0}}, "OBJECT 2 8 0.3 Fixed brown\nOBJECT 6 9 0.3 Fixed white\n"));
  EXPECT_FALSE(sees(field.percept(1), Kind::Object, Colour::Brown));
  EXPECT_TRUE(sees(field.percept(1), Kind::Object, Colour::White));
}

TEST(Object, IsNoObstacle) {
  Field field = with_object("Fixed brown");
  repeat(field, 20, {acting(1, Act::None, {1.0, 0.0})});
  EXPECT_GT(field.place(1).x(), 4.5);
}

TEST(Object, IsInTheViewWhileItLies) {
  Field field = with_object("Movable brown", "OBJECT 9 5 0.5 Fixed white\n");
  ASSERT_EQ(field.view.objects.size(), 2U);
  EXPECT_EQ(field.view.objects[1].object, ObjectId{2});
  EXPECT_EQ(field.view.objects[1].position_m, (WorldVec{9.0, 5.0}));
  EXPECT_EQ(field.view.objects[1].colour, Colour::White);
  field.step({acting(1, Act::PickUp)});
  ASSERT_EQ(field.view.objects.size(), 1U);
  EXPECT_EQ(field.view.objects[0].object, ObjectId{2});
}

TEST(PickUpObject, TakesAMovableOneWhichNobodySeesAnyMore) {
  Field field = with_object("Movable brown");
  field.step({about(1, Act::PickUp, Colour::Brown)});
  EXPECT_EQ(field.all<ObjectTaken>(), (std::vector<ObjectTaken>{{RobotId{1}, ObjectId{1}}}));
  EXPECT_TRUE(field.percept(1).holding);
  EXPECT_EQ(field.percept(1).held, Colour::Brown);
  EXPECT_TRUE(field.percept(1).deeds.picked_up);
  EXPECT_FALSE(sees(field.percept(1), Kind::Object, Colour::Brown));
}

TEST(PickUpObject, LeavesWhatIsFixedAContainerOrOfAnotherColour) {
  for (const char* kind : {"Fixed brown", "Container brown", "Movable orange"}) {
    Field field = with_object(kind);
    field.step({about(1, Act::PickUp, Colour::Brown)});
    EXPECT_FALSE(field.percept(1).holding) << kind;
  }
}

TEST(PickUpObject, WithoutAColourTakesAny) {
  Field field = with_object("Movable orange");
  field.step({acting(1, Act::PickUp)});
  EXPECT_EQ(field.percept(1).held, Colour::Orange);
  EXPECT_TRUE(field.percept(1).holding);
}

TEST(PickUpObject, ReachesToTheRim) {
  for (const double x_m : {4.29, 4.31}) {
    Field field(
        on_floor({{3.0, 5.0, 0.0}}, "OBJECT " + std::to_string(x_m) + " 5 0.3 Movable brown\n"));
    field.step({acting(1, Act::PickUp)});
    EXPECT_EQ(field.percept(1).holding, x_m < 4.3);
  }
}

TEST(PickUpObject, TakesTheOneWithTheNearestRim) {
  Field field = with_object("Movable brown", "OBJECT 2.2 5 0.05 Movable brown\n");
  field.step({acting(1, Act::PickUp)});
  EXPECT_EQ(field.all<ObjectTaken>()[0].object, ObjectId{1});
}

TEST(PickUpObject, DoesNotReachThroughAWall) {
  Field field(on_floor({{3.0, 5.5, 0.0}}, "OBJECT 3 6.5 0.3 Movable brown\n"));
  field.step({acting(1, Act::PickUp)});
  EXPECT_FALSE(field.percept(1).holding);
}

TEST(PickUpObject, TakesNoSecondOne) {
  Field field = with_object("Movable brown", "OBJECT 2.2 5 0.1 Movable brown\n");
  repeat(field, 2, {acting(1, Act::PickUp)});
  EXPECT_TRUE(field.all<ObjectTaken>().empty());
  EXPECT_TRUE(field.percept(1).holding);
}

TEST(DropObject, LaysItDownWhereTheRobotIs) {
  Field field = with_object("Movable brown");
  field.step({acting(1, Act::PickUp)});
  repeat(field, 20, {acting(1, Act::None, {1.0, 0.0})});
  field.step({acting(1, Act::Drop)});
  const WorldVec place = field.place(1);
  ASSERT_EQ(field.all<ObjectDropped>(),
            (std::vector<ObjectDropped>{{RobotId{1}, ObjectId{1}, place}}));
  EXPECT_GT(place.x(), 4.0);
  EXPECT_FALSE(field.percept(1).holding);
  EXPECT_TRUE(field.percept(1).deeds.dropped);
  EXPECT_EQ(field.view.objects[0].position_m, place);
}

TEST(DropObject, InReachOfAContainerStoresItForGood) {
  Field field = with_object("Movable brown", "OBJECT 2.2 5 0.1 Container green\n");
  field.step({acting(1, Act::PickUp)});
  field.step({acting(1, Act::Drop)});
  EXPECT_EQ(field.all<ObjectStored>(),
            (std::vector<ObjectStored>{{RobotId{1}, ObjectId{1}, ObjectId{2}}}));
  EXPECT_TRUE(field.percept(1).deeds.stored);
  EXPECT_FALSE(field.percept(1).holding);
  EXPECT_FALSE(sees(field.percept(1), Kind::Object, Colour::Brown));
  field.step({acting(1, Act::PickUp)});
  EXPECT_FALSE(field.percept(1).holding);
}

TEST(DropObject, OfNothingIsNothing) {
  Field field = with_object("Movable brown");
  field.step({acting(1, Act::Drop)});
  EXPECT_TRUE(field.all<ObjectDropped>().empty());
  EXPECT_FALSE(field.percept(1).deeds.dropped);
}

TEST(TestObject, FindsAMovableOneDangerousAndOthersHarmless) {
  for (const auto& [kind, finding] :
       {std::pair{"Movable brown", Finding::Dangerous}, std::pair{"Fixed brown", Finding::Harmless},
        std::pair{"Container brown", Finding::Harmless}}) {
    Field field = with_object(kind);
    field.step({about(1, Act::Test, Colour::Brown)});
    EXPECT_EQ(field.percept(1).deeds.tested, finding) << kind;
    EXPECT_EQ(field.all<ObjectTested>(),
              (std::vector<ObjectTested>{{RobotId{1}, ObjectId{1}, finding}}));
  }
}

TEST(TestObject, PaintsItGreySoThatItIsTestedOnce) {
  for (const std::optional<Colour> colour :
       {std::optional(Colour::Brown), std::optional<Colour>()}) {
    Field field = with_object("Fixed brown");
    field.step({about(1, Act::Test, colour)});
    EXPECT_FALSE(sees(field.percept(1), Kind::Object, Colour::Brown));
    EXPECT_TRUE(sees(field.percept(1), Kind::Object, Colour::Grey));
    field.step({about(1, Act::Test, colour)});
    EXPECT_EQ(field.percept(1).deeds.tested, Finding::None);
    EXPECT_TRUE(field.all<ObjectTested>().empty());
  }
}

TEST(TestObject, IsAboutTheColourThatIsWanted) {
  Field field = with_object("Fixed white", "OBJECT 2 5 0.05 Movable brown\n");
  field.step({about(1, Act::Test, Colour::Brown)});
  EXPECT_EQ(field.all<ObjectTested>()[0].object, ObjectId{2});
}

TEST(TestObject, DoesNothingOutOfReach) {
  Field field(on_floor({{3.0, 5.0, 0.0}}, "OBJECT 6 5 0.3 Movable brown\n"));
  field.step({acting(1, Act::Test)});
  EXPECT_EQ(field.percept(1).deeds.tested, Finding::None);
}

}  // namespace
}  // namespace tacit
