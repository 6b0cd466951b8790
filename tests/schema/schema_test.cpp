#include "idl/schema/schema.h"

#include <gtest/gtest.h>

#include "idl/wire/teamPubSubTypes.h"

namespace tacit {
namespace {

TEST(Schema, OfEveryStructHasTextOfItsOwn) {
  ASSERT_GT(schemas().size(), 20U);
  for (const WireSchema& schema : schemas()) {
    EXPECT_FALSE(schema.text.empty()) << schema.name;
    EXPECT_EQ(ros2msg_schema(schema.name), schema.text) << "the name stands twice: " << schema.name;
  }
}

TEST(Schema, OfNobodyIsEmpty) { EXPECT_EQ(ros2msg_schema("tacit_wire/msg/Nobody"), ""); }

/// The name that the wire type has in Fast DDS, as ROS would have it.
template <class Support>
std::string ros_name() {
  const std::string name = Support().getName();
  return "tacit_wire/msg/" + name.substr(name.rfind(':') + 1);
}

TEST(Schema, OfATopicIsThatOfItsWireType) {
  EXPECT_EQ(schema_name<topics::WorldView>(), ros_name<wire::WorldViewPubSubType>());
  EXPECT_EQ(schema_name<topics::Trajectory>(), ros_name<wire::WorldViewPubSubType>());
  EXPECT_EQ(schema_name<topics::Events>(), ros_name<wire::EventBatchPubSubType>());
  EXPECT_EQ(schema_name<topics::Status>(), ros_name<wire::RunStatusPubSubType>());
  EXPECT_EQ(schema_name<topics::Telemetry>(), ros_name<wire::TelemetryPubSubType>());
  EXPECT_FALSE(schema_of<topics::WorldView>().text.empty());
  EXPECT_FALSE(schema_of<topics::Events>().text.empty());
  EXPECT_FALSE(schema_of<topics::Status>().text.empty());
  EXPECT_FALSE(schema_of<topics::Telemetry>().text.empty());
}

}  // namespace
}  // namespace tacit
