#include "idl/cdl/parse.h"

#include <gtest/gtest.h>

#include "tests/cdl/samples.h"

namespace tacit::cdl {
namespace {

struct Refused {
  std::string text;
  std::size_t line;
  std::size_t column;
  std::string said;
};

class RefusedText : public testing::TestWithParam<Refused> {};

TEST_P(RefusedText, SaysWhereAndWhatWasWanted) {
  const Findings findings = parse(GetParam().text).findings;
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].line, GetParam().line) << findings[0].text;
  EXPECT_EQ(findings[0].column, GetParam().column) << findings[0].text;
  EXPECT_NE(findings[0].text.find(GetParam().said), std::string::npos) << findings[0].text;
}

INSTANTIATE_TEST_SUITE_P(
    Sample, RefusedText,
    testing::Values(
        Refused{"instBPP<1,2> a form b(c);", 1, 16, "wanted \"from\""},
        Refused{"bindArch AuRA\ninstBP a from b();", 2, 1, "wanted \";\""},
        Refused{"intsBP<1,2> a from b();", 1, 1, "did you mean \"instBP\"?"},
        Refused{"\n  instBP a from b(c = {1;", 2, 23, "without its end, wanted \"}\""},
        Refused{"instBP a from b(c = {1}", 1, 24, "end of the file, wanted \",\" or \")\""},
        Refused{"instBP a from [b)];", 1, 17, "wanted \",\" or \"]\""},
        Refused{"instBP a from b(, c);", 1, 17, "wanted a name"},
        Refused{"instBP |a from b();", 1, 8, "wanted a second \"|\""},
        Refused{"instBP a from b(rules[S] = if [x] got T);", 1, 35, "wanted \"goto\""},
        Refused{"instBP a from b(%p);", 1, 19, "wanted \"=\""},
        Refused{"instBP a from ;", 1, 15, "wanted what a is made from"},
        Refused{"instBP a from b:c;", 1, 18, "wanted \"(\""},
        Refused{"defOp a (b", 1, 11, "wanted \";\" at the end of the definition"},
        Refused{"bindArch ;", 1, 10, "architecture"}, Refused{"/* no end", 1, 1, "\"*/\""},
        Refused{std::string("bindArch A\0;", 12), 1, 11, "NUL"},
        Refused{"bindArch \xFF;", 1, 10, "the byte 255"}, Refused{"]", 1, 1, "a statement"}));

TEST(Parser, GoesOnBehindAnError) {
  const Parsed parsed = parse("instBP a form b();\ninstBP c from d();\ninstBP e form f();\n");
  EXPECT_EQ(parsed.findings.size(), 2U);
  ASSERT_EQ(parsed.mission.statements.size(), 1U);
  EXPECT_EQ(parsed.mission.statements[0].name, "c");
}

TEST(Parser, KeepsTheStatementBehindOneWithoutItsEnd) {
  const Parsed parsed = parse("instBP a from b()\ninstBP c from d();");
  ASSERT_EQ(parsed.mission.statements.size(), 1U);
  EXPECT_EQ(parsed.mission.statements[0].name, "c");
}

TEST(Parser, StopsAfterManyErrors) {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    text += "instBP a;\n";
  }
  EXPECT_EQ(parse(text).findings.size(), kMostErrors + 1);
}

TEST(Parser, RefusesListsThatAreTooDeep) {
  const Parsed parsed = parse(std::string(1'000'000, '['));
  ASSERT_FALSE(parsed.findings.empty());
  EXPECT_EQ(parsed.findings[0].column, static_cast<std::size_t>(kDeepest) + 1);
}

TEST(Parser, ReadsListsAsDeepAsAllowed) {
  EXPECT_TRUE(parse(std::string(kDeepest, '[') + std::string(kDeepest, ']')).findings.empty());
}

TEST(Parser, KeepsBytesBeyondAsciiInDescriptionsCommentsAndValues) {
  const Parsed parsed = parse("/* \xE9 */ instBP |caf\xE9| a from b(c = {\"\xC3\xA4\"});");
  ASSERT_TRUE(parsed.findings.empty());
  EXPECT_EQ(parsed.mission.statements[0].description, "caf\xE9");
  EXPECT_EQ(parsed.mission.statements[0].comments, Comments{"/* \xE9 */"});
}

TEST(Parser, KeepsADefinitionAsText) {
  const Mission mission = parse("defOp [AuRA] Hum(a; {;}) style;").mission;
  ASSERT_EQ(mission.statements.size(), 1U);
  EXPECT_EQ(mission.statements[0].keyword, "defOp");
  EXPECT_EQ(mission.statements[0].name, "Hum");
  EXPECT_EQ(mission.statements[0].text, "defOp [AuRA] Hum(a; {;}) style");
}

TEST(Parser, ReadsARule) {
  const Mission mission = parse("[rules[S]<1,2>|s| = if [Near]<3,4>|t| goto $AN_1]").mission;
  const Item& rule = mission.statements.at(0).body.items.at(0);
  EXPECT_EQ(rule.slot->index, "S");
  EXPECT_EQ(rule.slot->place, (Place{1, 2}));
  EXPECT_EQ(rule.value.kind, Expression::Kind::Rule);
  EXPECT_EQ(rule.value.name, "$AN_1");
  EXPECT_EQ(rule.value.items.at(0).value.description, "t");
}

TEST(Parser, ReadsAConnectionThatIsNotMade) {
  const Mission mission = parse("[v<0,0> = , w = ]").mission;
  EXPECT_EQ(mission.statements.at(0).body.items.at(0).value.kind, Expression::Kind::Nothing);
  EXPECT_EQ(mission.statements.at(0).body.items.size(), 2U);
}

TEST(Parser, ReadsTheSamplesOfOurOwn) {
  EXPECT_TRUE(parse(own_sample("patrol.cdl")).findings.empty());
  EXPECT_TRUE(parse(own_sample("learner.cdl")).findings.empty());
}

}  // namespace
}  // namespace tacit::cdl
