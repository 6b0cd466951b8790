#include "idl/cdl/print.h"

#include <gtest/gtest.h>

#include "idl/cdl/parse.h"
#include "idl/types/random.h"
#include "tests/cdl/samples.h"

namespace tacit::cdl {
namespace {

using Kind = Expression::Kind;

std::string any_word(Stream& chance) {
  static const std::vector<std::string> kWords{"Start", "$AN_12", "Standby*", "a.b", "NOISE", "x1"};
  return kWords[chance.below(kWords.size())];
}

Comments any_comments(Stream& chance) {
  return chance.below(6) == 0 ? Comments{"/* a\n b */", "// line"} : Comments{};
}

void any_headings(Stream& chance, std::optional<Place>& place,
                  std::optional<std::string>& description) {
  if (chance.below(2) == 0) {
    place = Place{static_cast<double>(chance.below(1000)) / 4.0, -100000.0};
  }
  if (chance.below(3) == 0) {
    description = "any, \"text\" {here}\n[] ;";
  }
}

Expression any_expression(Stream& chance, int depth);

Item any_item(Stream& chance, int depth) {
  Item item;
  item.comments = any_comments(chance);
  item.value = any_expression(chance, depth);
  const bool needs_slot = item.value.kind == Kind::Nothing;
  if (needs_slot || chance.below(2) == 0) {
    Slot slot{any_word(chance).substr(0, 1) == "$" ? "v" : "%w", false, {}, {}, {}};
    slot.is_parameter = slot.name[0] == '%';
    slot.name = slot.is_parameter ? "w" : slot.name;
    if (chance.below(3) == 0) {
      slot.index = any_word(chance);
    }
    any_headings(chance, slot.place, slot.description);
    item.slot = slot;
  }
  return item;
}

Expression any_expression(Stream& chance, int depth) {
  Expression made;
  made.kind = static_cast<Kind>(chance.below(depth > 4 ? 3 : 6));
  if (made.kind == Kind::Nothing) {
    return made;
  }
  made.name = made.kind == Kind::Group   ? ""
              : made.kind == Kind::Value ? "10, \"}\" | 2"
                                         : any_word(chance);
  if (made.kind == Kind::Rule) {
    Item condition;
    condition.comments = any_comments(chance);
    condition.value.kind = Kind::Group;
    condition.value.items.push_back(any_item(chance, depth + 1));
    made.items.push_back(condition);
    return made;
  }
  if (made.kind == Kind::Instance || made.kind == Kind::Group) {
    made.labels.assign(chance.below(3), any_word(chance));
    for (std::uint64_t i = chance.below(4); i > 0; --i) {
      made.items.push_back(any_item(chance, depth + 1));
    }
    made.closing_comments = any_comments(chance);
  }
  any_headings(chance, made.place, made.description);
  return made;
}

Mission any_mission(Stream& chance) {
  Mission mission;
  for (std::uint64_t i = chance.below(4); i > 0; --i) {
    Statement statement;
    statement.kind = Statement::Kind::Instantiation;
    statement.comments = any_comments(chance);
    statement.keyword = "instGroup";
    statement.name = any_word(chance);
    any_headings(chance, statement.place, statement.description);
    do {
      statement.body = any_expression(chance, 0);
    } while (statement.body.kind == Kind::Nothing);
    mission.statements.push_back(statement);
  }
  mission.closing_comments = any_comments(chance);
  return mission;
}

TEST(Print, GivesBackAnyMission) {
  Stream chance(7, "missions");
  for (int i = 0; i < 3000; ++i) {
    const Mission mission = any_mission(chance);
    const std::string text = print(mission);
    const Parsed parsed = parse(text);
    ASSERT_TRUE(parsed.findings.empty()) << to_text(parsed.findings[0], "x") << '\n' << text;
    ASSERT_EQ(parsed.mission, mission) << text;
    ASSERT_EQ(print(parsed.mission), text);
    ASSERT_EQ(print(parsed.mission, text), text);
  }
}

TEST(Print, LeavesAnUneditedFileAsItIs) {
  for (const char* name : {"patrol.cdl", "learner.cdl"}) {
    const std::string text = own_sample(name);
    EXPECT_EQ(print(parse(text).mission, text), text);
  }
}

constexpr const char* kSpread = "// a\ninstBP  a   from b( x={1} ,  /*two*/ y = {2}  )  ;\n\n [a ]";

std::string edited(const char* text, void (*edit)(Mission&)) {
  Mission mission = parse(text).mission;
  edit(mission);
  return print(mission, text);
}

TEST(Print, ChangesOnlyTheTextOfAnEditedValue) {
  EXPECT_EQ(edited(kSpread, [](Mission& m) { m.statements[0].body.items[1].value.name = "3"; }),
            "// a\ninstBP  a   from b( x={1} ,  /*two*/ y = {3}  )  ;\n\n [a ]");
}

TEST(Print, ChangesOnlyTheTextAroundAnAddedItem) {
  EXPECT_EQ(edited(kSpread,
                   [](Mission& m) {
                     Item added = m.statements[0].body.items[0];
                     added.slot->name = "z";
                     added.span = {};
                     m.statements[0].body.items.push_back(added);
                   }),
            "// a\ninstBP  a   from b( x={1} ,  /*two*/ y = {2},\n  z = {1})  ;\n\n [a ]");
}

TEST(Print, TellsACommentOnceThatStandsBeforeWhatWasEdited) {
  const std::string source = "instGroup $A from // why\n [$B, $C];\n[$A]\n";
  Mission mission = parse(source).mission;
  ASSERT_EQ(mission.statements[0].body.items[0].comments, Comments{"// why"});
  mission.statements[0].body.items.pop_back();
  mission.statements[0].body.place = Place{1.0, 2.0};
  EXPECT_EQ(parse(print(mission, source)).mission, mission) << print(mission, source);
}

TEST(Print, TakesAStatementOutAndKeepsTheOthers) {
  EXPECT_EQ(edited("bindArch A;\ninstBP  a from b( );\ninstBP  c from d( );\n",
                   [](Mission& m) { m.statements.erase(m.statements.begin() + 1); }),
            "bindArch A;\n\ninstBP  c from d( );\n");
}

TEST(Print, EndsATeamBeforeAnother) {
  EXPECT_EQ(print(parse("[a]; [b]; defOp c;").mission), "[\n  a];\n\n[\n  b]\n\ndefOp c;\n");
}

TEST(Print, KeepsCommentsAroundADefinition) {
  EXPECT_EQ(print(parse("/*1*/ defOp /*2*/ a /*3*/; /*4*/").mission),
            "/*1*/\ndefOp /*2*/ a;\n/*3*/\n/*4*/\n");
}

TEST(Print, KeepsCommentsInTheHouseLayout) {
  EXPECT_EQ(print(parse("/*1*/ [ /*2*/ a, // 3\n b /*4*/ ] /*5*/").mission),
            "/*1*/\n[\n  /*2*/\n  a,\n  // 3\n  b\n  /*4*/\n]\n/*5*/\n");
}

}  // namespace
}  // namespace tacit::cdl
