#include "idl/cdl/vocabulary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace tacit::cdl {
namespace {

const VocabularyRow& row_of(std::string_view word, Use use, std::string_view parameter) {
  const auto rows = parameters_of(word, use);
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const VocabularyRow& row) {
    return row.parameter == parameter;
  });
  EXPECT_NE(found, rows.end()) << word << ' ' << parameter;
  return *found;
}

TEST(Vocabulary, FindsAllRowsOfEachWord) {
  std::size_t rows = 0;
  for (const Use use : {Use::Behaviour, Use::Trigger}) {
    for (const std::string& word : words_for(use)) {
      rows += parameters_of(word, use).size();
    }
  }
  EXPECT_EQ(rows, vocabulary().size());
}

TEST(Vocabulary, HasEachParameterOnce) {
  std::set<std::tuple<std::string_view, Use, std::string_view>> seen;
  for (const VocabularyRow& row : vocabulary()) {
    EXPECT_TRUE(seen.emplace(row.word, row.use, row.parameter).second)
        << row.word << ' ' << row.parameter;
  }
}

TEST(Vocabulary, HasDefaultsThatFit) {
  for (const VocabularyRow& row : vocabulary()) {
    if (!row.default_value.empty()) {
      EXPECT_EQ(misfit(row, parse_value(row.default_value)), std::nullopt)
          << row.word << ' ' << row.parameter;
    }
  }
}

TEST(Vocabulary, TellsAWordsUsesApart) {
  EXPECT_FALSE(parameters_of("AtGoal", Use::Trigger).empty());
  EXPECT_TRUE(parameters_of("AtGoal", Use::Behaviour).empty());
  EXPECT_TRUE(parameters_of("Hum", Use::Behaviour).empty());
}

TEST(Vocabulary, SaysWhatAParameterTakes) {
  EXPECT_EQ(misfit(row_of("Wait", Use::Trigger, "Delay"), parse_value("Long")),
            "a number from 0 to 86400 s");
  EXPECT_EQ(misfit(row_of("GoTo", Use::Behaviour, "Goal_Location"), parse_value("1, 2, 3, 4")),
            "a point: x, y in m, or the name of one");
  EXPECT_EQ(misfit(row_of("GoTo", Use::Behaviour, "Goal_Location"), parse_value("1, 2, 3")),
            std::nullopt);
  EXPECT_EQ(misfit(row_of("GoTo", Use::Behaviour, "Goal_Location"), parse_value("Gate")),
            std::nullopt);
  EXPECT_EQ(misfit(row_of("Detect", Use::Trigger, "Objects"), parse_value("2")),
            "words, such as Mines | Robots");
}

TEST(Vocabulary, TakesAnyValueFromAbove) {
  for (const VocabularyRow& row : vocabulary()) {
    EXPECT_EQ(misfit(row, FromAbove{}), std::nullopt) << row.word;
  }
}

}  // namespace
}  // namespace tacit::cdl
