#include "console/report/metrics_table.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

TEST(MetricsTable, HasARowPerMetric) {
  EXPECT_EQ(metrics_table(Tally()).rows.size(), Tally().metrics().size());
}

TEST(MetricsTable, ShowsCountsMeasuresAndWhatIsAbsent) {
  Tally tally;
  tally.add({1, EnemyCreated{}});
  tally.add({2, Checkpoint{0, 0, 12.345, 0.5}});
  const std::string text = to_text(metrics_table(tally));

  EXPECT_NE(text.find("created                    1        Normal enemies created."),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("mean_death_distance_m      –  m"), std::string::npos) << text;
  EXPECT_NE(text.find("idle_mean_distance_m   12.35  m"), std::string::npos) << text;
}

}  // namespace
}  // namespace tacit
