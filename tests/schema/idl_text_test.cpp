#include "idl/schema/idl_text.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

IdlMember member_of(const std::string& declaration) {
  return parse_idl("struct A { double x; }; struct B { " + declaration + " };", "f.idl")[1]
      .members.at(0);
}

std::string complaint(const std::string& text) {
  try {
    (void)parse_idl(text, "f.idl");
  } catch (const IdlError& error) {
    return error.what();
  }
  return "";
}

TEST(IdlText, GivesStructsWithTheirModules) {
  const auto structs =
      parse_idl("module a { module b { struct C { octet d; }; }; }; struct E { octet f; };", "");
  ASSERT_EQ(structs.size(), 2U);
  EXPECT_EQ(structs[0].scope, "a::b");
  EXPECT_EQ(structs[0].name, "C");
  EXPECT_EQ(structs[1].scope, "");
}

TEST(IdlText, ReadsEveryBasicType) {
  for (const std::string type :
       {"boolean", "octet", "char", "short", "unsigned short", "long", "unsigned long", "long long",
        "unsigned long long", "float", "double", "string"}) {
    EXPECT_EQ(member_of(type + " x;").type, type);
  }
}

TEST(IdlText, ReadsBoundsOfTextsListsAndArrays) {
  EXPECT_EQ(member_of("string<32> x;").text_bound, 32U);
  const IdlMember list = member_of("sequence<A, 8> x;");
  EXPECT_TRUE(list.many == IdlMember::Many::Sequence && list.count == 8U && list.type == "A");
  EXPECT_FALSE(member_of("sequence<unsigned long long> x;").count.has_value());
  const IdlMember table = member_of("octet x[4][64];");
  EXPECT_TRUE(table.many == IdlMember::Many::Array && table.count == 256U);
}

TEST(IdlText, PassesOverComments) {
  EXPECT_EQ(parse_idl("// struct X\n/* a\n b */ struct A { // c\n octet d; };", "").size(), 1U);
}

TEST(IdlText, NamesTheLineOfWhatItDoesNotKnow) {
  EXPECT_EQ(complaint("struct A {\n  wstring x;\n};"),
            "f.idl:2: found \"wstring\", wanted a basic type, string, sequence or a struct that "
            "stands before");
  EXPECT_EQ(complaint("\n\nunion A {};"), "f.idl:3: found \"union\", wanted module or struct");
  EXPECT_EQ(complaint("/*\n*/ @mutable struct A {};"),
            "f.idl:2: found \"@\", wanted module or struct");
  EXPECT_EQ(complaint("struct A {\noctet x[N]; };"),
            "f.idl:2: found \"N\", wanted a number above 0");
  EXPECT_EQ(complaint("struct A { octet x;"), "f.idl:1: found the end, wanted a name");
  EXPECT_EQ(complaint("/* a"), "f.idl:1: the comment has no end");
  EXPECT_EQ(complaint("struct A { sequence<octet> x[3]; };"),
            "f.idl:1: found \"3\", wanted no array of sequences");
}

}  // namespace
}  // namespace tacit
