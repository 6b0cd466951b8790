#include <gtest/gtest.h>

#include <cstring>

#include "idl/bus/convert_lockstep.h"
#include "idl/wire/lockstepPubSubTypes.h"
#include "tests/wire/words.h"

namespace tacit {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;

constexpr std::size_t kEncapsulation = 4;

/// Fast DDS takes the generator's word for it; an agent that reads shared memory and one that reads
/// a network must see the same.
template <class Support, class Wire>
void expect_memory_is_wire(const Wire& wire) {
  Support support;
  ASSERT_TRUE(support.is_plain());
  ASSERT_TRUE(support.is_bounded());
  SerializedPayload_t payload(static_cast<std::uint32_t>(sizeof(Wire) + kEncapsulation + 64));
  Wire copy = wire;
  ASSERT_TRUE(support.serialize(&copy, &payload));
  ASSERT_EQ(payload.length, sizeof(Wire) + kEncapsulation);
  EXPECT_EQ(std::memcmp(payload.data + kEncapsulation, &wire, sizeof(Wire)), 0);
}

TEST(PlainTypes, APerceptInMemoryIsThePerceptOnTheWire) {
  wire::Percept wire;
  to_wire(test::Words(1).percept(), wire);
  expect_memory_is_wire<wire::PerceptPubSubType>(wire);
}

TEST(PlainTypes, ACommandInMemoryIsTheCommandOnTheWire) {
  wire::Command wire;
  to_wire(test::Words(2).command(), wire);
  expect_memory_is_wire<wire::CommandPubSubType>(wire);
}

TEST(PlainTypes, APerceptHoldsAsMuchAsTheWordAllows) {
  wire::Percept wire;
  EXPECT_EQ(wire.sightings().size(), Percept::kMaxSightings);
  EXPECT_EQ(wire.obstacles().size(), Percept::kMaxObstacles);
  EXPECT_EQ(wire.doorways().size(), Percept::kMaxDoorways);
  EXPECT_EQ(wire.heard().size(), Percept::kMaxHeard);
  EXPECT_EQ(wire.heard()[0].size(), Word::kMaxLength + 1);
}

TEST(PlainTypes, HaveNoPaddingAtTheirEnd) {
  EXPECT_EQ(sizeof(wire::Percept) % 8, 0U);
  EXPECT_EQ(sizeof(wire::Command) % 8, 0U);
}

}  // namespace
}  // namespace tacit
