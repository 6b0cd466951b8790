#include "console/report/table.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace tacit {
namespace {

Table a_table() {
  Table table;
  table.title = "Distance";
  table.columns = {{"learner", "learner", 1, false},
                   {"runs", "runs", 1, false},
                   {"distance_m", "distance m", 2, true}};
  table.rows = {{std::string("lm"), std::int64_t{100}, Estimate{61.256, 60.0, 62.5}},
                {std::string("static1"), std::int64_t{7}, std::monostate{}}};
  return table;
}

TEST(TableText, AlignsWordsLeftAndFiguresRight) {
  EXPECT_EQ(to_text(a_table()),
            "Distance\n"
            "learner  runs            distance m\n"
            "lm        100  61.26 [60.00, 62.50]\n"
            "static1     7                     –\n");
}

TEST(TableText, RoundsToTheDecimalsOfItsColumn) {
  Table table;
  table.columns = {{"a", "a", 0, false}, {"b", "b", 3, false}};
  table.rows = {{2.6, 1.0}};

  EXPECT_EQ(to_text(table), "a      b\n3  1.000\n");
}

TEST(TableText, ShowsInfinityAndNotANumberAsAbsent) {
  Table table;
  table.columns = {{"a", "a", 1, false}};
  table.rows = {{std::numeric_limits<double>::infinity()},
                {std::numeric_limits<double>::quiet_NaN()}};

  EXPECT_EQ(to_text(table), "a\n–\n–\n");
}

TEST(TableCsv, GivesAnIntervalColumnsOfItsOwn) {
  EXPECT_EQ(to_csv(a_table()),
            "learner,runs,distance_m,distance_m_low,distance_m_high\r\n"
            "lm,100,61.256,60,62.5\r\n"
            "static1,7,,,\r\n");
}

TEST(TableCsv, QuotesWhatWouldBreakTheLine) {
  Table table;
  table.columns = {{"a", "a", 1, false}};
  table.rows = {{std::string("six, \"lm\"\nand one")}};

  EXPECT_EQ(to_csv(table), "a\r\n\"six, \"\"lm\"\"\nand one\"\r\n");
}

TEST(TableCsv, LeavesAFieldEmptyThatIsNoNumber) {
  Table table;
  table.columns = {{"a", "a", 1, false}, {"b", "b", 1, false}};
  table.rows = {{std::numeric_limits<double>::infinity(), 1.5}};

  EXPECT_EQ(to_csv(table), "a,b\r\n,1.5\r\n");
}

TEST(TableCsv, EveryRowHasAsManyFieldsAsTheHeader) {
  Table table = a_table();
  table.rows.push_back({std::monostate{}, 1.5, 2.5});
  const std::string csv = to_csv(table);
  std::size_t commas = 0;
  for (const char c : csv) {
    commas += c == ',' ? 1 : 0;
  }
  EXPECT_EQ(commas, 4 * (1 + table.rows.size()));
}

TEST(TableJson, ReadsBack) {
  const auto json = nlohmann::json::parse(to_json(a_table()));

  EXPECT_EQ(json["title"], "Distance");
  EXPECT_EQ(json["rows"][0]["learner"], "lm");
  EXPECT_EQ(json["rows"][0]["runs"], 100);
  EXPECT_EQ(json["rows"][0]["distance_m"]["value"], 61.256);
  EXPECT_EQ(json["rows"][0]["distance_m"]["high"], 62.5);
  EXPECT_TRUE(json["rows"][1]["distance_m"].is_null());
}

TEST(TableJson, EscapesEveryCharacterThatJsonReserves) {
  std::string all;
  for (char c = 1; c < 127; ++c) {
    all += c;
  }
  Table table;
  table.columns = {{"a", "a", 1, false}};
  table.rows = {{all}};

  EXPECT_EQ(nlohmann::json::parse(to_json(table))["rows"][0]["a"], all);
}

TEST(TableJson, KeepsEveryBitOfANumber) {
  Table table;
  table.columns = {{"a", "a", 1, false}};
  table.rows = {{0.1 + 0.2}, {1e300}, {5e-324}};
  const auto json = nlohmann::json::parse(to_json(table));

  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    EXPECT_EQ(json["rows"][i]["a"].get<double>(), std::get<double>(table.rows[i][0]));
  }
}

TEST(TableJson, HasNullForWhatIsNoNumber) {
  Table table;
  table.columns = {{"a", "a", 1, false}};
  table.rows = {{std::numeric_limits<double>::quiet_NaN()}};

  EXPECT_TRUE(nlohmann::json::parse(to_json(table))["rows"][0]["a"].is_null());
}

TEST(TableJson, OfNoRowsIsAnEmptyList) {
  EXPECT_TRUE(nlohmann::json::parse(to_json(Table{}))["rows"].empty());
}

}  // namespace
}  // namespace tacit
