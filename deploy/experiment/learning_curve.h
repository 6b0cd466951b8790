#pragma once

#include <vector>

#include "console/report/chart.h"
#include "console/report/table.h"
#include "deploy/experiment/grouping.h"

namespace tacit {

/// How the score of chains changes from run to run.
class LearningCurve {
 public:
  LearningCurve(const Battery& battery, const Results& results)
      : battery_(battery), results_(results) {}

  /// The mean score of every run in the chains, per variant or rival and team size.
  [[nodiscard]] Table episodes() const;
  /// The last runs of each chain against its first, as many as are evaluated; paired t-test over
  /// chains, p after Holm.
  [[nodiscard]] Table learned() const;
  /// A curve per team size where there are several, else one per variant and rival.
  [[nodiscard]] Chart chart() const;

 private:
  [[nodiscard]] std::vector<Group> groups() const;
  [[nodiscard]] std::vector<double> scores(const Group& group, std::int64_t episode) const;
  /// The mean of `evaluate` runs of every chain from `first` on.
  [[nodiscard]] std::vector<double> stretch(const Group& group, std::int64_t first) const;
  void add_learned(Table& table, const Group& group, std::vector<double>& p_values) const;
  [[nodiscard]] ChartSeries series(const Group& group) const;

  const Battery& battery_;
  const Results& results_;
};

}  // namespace tacit
