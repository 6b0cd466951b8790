#include <gtest/gtest.h>

#include <cmath>

#include "idl/scenario/run_config.h"
#include "idl/scenario/scenario_file.h"
#include "tests/scenario/sample_config.h"

namespace tacit {
namespace {

SampleConfig awkward() {
  SampleConfig config;
  config.radius_m = 0.1 + 0.2;
  config.count = 7;
  config.walls = false;
  config.learner = "static1";
  config.note = "a \"quoted\" \\ line\nbreak, tab\t and ü";
  config.discs = {{1.0 / 3.0, 1e-17, 99.0}, {4.0, 5.0, 6.0}};
  config.tags = {"one", "a \"b\""};
  return config;
}

TEST(ToToml, ReadsBackToTheSameBits) {
  SampleConfig written = awkward();
  const SampleConfig read = loaded(to_toml(describing(written)));
  EXPECT_EQ(read.radius_m, written.radius_m);
  EXPECT_EQ(read.count, written.count);
  EXPECT_EQ(read.walls, written.walls);
  EXPECT_EQ(read.learner, written.learner);
  EXPECT_EQ(read.note, written.note);
  EXPECT_EQ(read.discs, written.discs);
  EXPECT_EQ(read.tags, written.tags);
}

TEST(ToToml, PrintsTheSameTextAfterReadingItsOwn) {
  SampleConfig config = awkward();
  const std::string text = to_toml(describing(config));
  SampleConfig again = loaded(text);
  EXPECT_EQ(to_toml(describing(again)), text);
}

TEST(ToToml, WritesMeaningRangeAndUnitAboveEachValue) {
  SampleConfig config;
  const std::string text = to_toml(describing(config));
  EXPECT_NE(text.find("# The team.\n[robots]\n# Body radius. [ours: a number] (0.05 to 5 m)\n"
                      "radius_m = 0.25\n"),
            std::string::npos)
      << text;
}

TEST(ToToml, HoldsSeveralStructs) {
  RunConfig run;
  SampleConfig sample;
  const std::string text = to_toml([&](ParameterVisitor& visitor) {
    describe(run, visitor);
    describe(sample, visitor);
  });
  EXPECT_NE(text.find("[run]"), std::string::npos);
  EXPECT_NE(text.find("[robots]"), std::string::npos);
}

TEST(Explain, ListsKeyValueUnitRangeAndMeaning) {
  SampleConfig config;
  const std::string text = explain(describing(config));
  const std::size_t line = text.find("radius_m");
  ASSERT_NE(line, std::string::npos);
  const std::string row = text.substr(line, text.find('\n', line) - line);
  for (const char* part : {"0.25", " m ", "0.05 to 5", "Body radius. [ours: a number]"}) {
    EXPECT_NE(row.find(part), std::string::npos) << row;
  }
}

TEST(Explain, AlignsTheMeanings) {
  SampleConfig config;
  config.discs = {{1.0, 2.0, 3.0}};
  const std::string text = explain(describing(config));
  const auto column = [&text](const std::string& word) {
    const std::size_t at = text.find(word);
    return at - text.rfind('\n', at);
  };
  EXPECT_EQ(column("Body radius"), column("Team size"));
  EXPECT_EQ(column("Body radius"), column("What adapts"));
}

}  // namespace
}  // namespace tacit
