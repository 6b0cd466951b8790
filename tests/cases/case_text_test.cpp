#include "wizard_service/cases/case_text.h"

#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "tests/cases/some_cases.h"

namespace tacit::cbr {
namespace {

TEST(CaseText, ReadsBackWhatItPrints) {
  Case one = testing::shipped_case("biohazard_pair", Task::Biohazard);
  one.features.handles_enemy = true;
  one.record = {3, 2, 1500, {{"Enter Library: nobody was there.", "office"}}};
  const Case again = case_from(to_text(one), "again.cdl");
  EXPECT_EQ(again.title, one.title);
  EXPECT_EQ(again.features, one.features);
  EXPECT_EQ(again.plan, one.plan);
  EXPECT_EQ(again.record, one.record);
}

std::string refusal(const std::string& text) {
  try {
    (void)case_from(text, "case.cdl");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return {};
}

TEST(CaseText, RefusesAnUnknownValueWithItsLine) {
  const std::string text = to_text(testing::shipped_case("eod", Task::ExplosiveOrdnance));
  std::string wrong = text;
  wrong.replace(wrong.find("Outdoor"), 7, "Seaside");
  const std::string told = refusal(wrong);
  EXPECT_NE(told.find("case.cdl:"), std::string::npos) << told;
  EXPECT_NE(told.find("Seaside"), std::string::npos) << told;
}

TEST(CaseText, RefusesAMissionWithoutATask) {
  EXPECT_NE(
      refusal(testing::text_of(testing::fs::path(TACIT_SOURCE_DIR) / "deploy/missions/eod.cdl")),
      "");
}

}  // namespace
}  // namespace tacit::cbr
