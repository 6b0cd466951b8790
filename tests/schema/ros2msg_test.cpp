#include "idl/schema/ros2msg.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

constexpr const char* kIdl = R"(
module tacit {
module wire {
struct Place { double x_m; double y_m; };
struct Named { string<32> name; Place at; };
struct Everything {
  boolean a; octet b; char c; short d; unsigned short e; long f; unsigned long g; long long h;
  unsigned long long i; float j; double k; string l;
  sequence<Named, 16> named;
  sequence<string> words;
  Place corners[4];
  octet heard[4][64];
};
};
};
)";

constexpr const char* kGolden = R"(bool a
uint8 b
uint8 c
int16 d
uint16 e
int32 f
uint32 g
int64 h
uint64 i
float32 j
float64 k
string l
tacit_wire/msg/Named[<=16] named
string[] words
tacit_wire/msg/Place[4] corners
uint8[256] heard
================================================================================
MSG: tacit_wire/msg/Named
string<=32 name
tacit_wire/msg/Place at
================================================================================
MSG: tacit_wire/msg/Place
float64 x_m
float64 y_m
)";

TEST(Ros2Msg, SaysMembersAndThenWhatTheyAreMadeOf) {
  const auto structs = parse_idl(kIdl, "f.idl");
  EXPECT_EQ(ros2msg_name(structs[2]), "tacit_wire/msg/Everything");
  EXPECT_EQ(ros2msg_text(structs[2], structs), kGolden);
}

}  // namespace
}  // namespace tacit
