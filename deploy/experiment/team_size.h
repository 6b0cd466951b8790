#pragma once

#include <vector>

#include "console/report/chart.h"
#include "console/report/decay_bootstrap.h"
#include "console/report/decay_fit.h"
#include "console/report/table.h"
#include "deploy/experiment/grouping.h"

namespace tacit {

/// The first measure against the size of the team (paper, section 3, Figure 4).
class TeamSizeStudy {
 public:
  TeamSizeStudy(const Battery& battery, const Results& results);

  /// Whether there are several team sizes and no parameters varied beside the variants, so that
  /// the mean over the other cells of a team size means something.
  [[nodiscard]] static bool applies(const Battery& battery);

  /// Mean and standard deviation over scenarios and seeds, per variant and over all; for all, also
  /// the lowest and the highest mean of a variant.
  [[nodiscard]] Table sizes() const;
  /// The decay a e^(-b n) + c of the cells' means with n, per variant and over all; scenarios are
  /// the blocks.
  [[nodiscard]] Table fits() const;
  /// What was measured and the fitted curve at each team size.
  [[nodiscard]] Table bands() const;
  [[nodiscard]] Chart chart() const;

 private:
  struct Fitted {
    Group group;
    DecayFit fit;
    DecayBootstrap samples;
  };

  void fit(const Group& group);
  void add_sizes(Table& table, const Group& group) const;
  [[nodiscard]] std::vector<double> variant_means(std::int64_t robots) const;
  [[nodiscard]] ChartSeries measured_series(const Group& group) const;
  [[nodiscard]] ChartSeries curve_series(const Fitted& fitted) const;

  const Battery& battery_;
  const Results& results_;
  std::string measure_;
  std::vector<Group> variants_;
  std::vector<Group> groups_;  ///< The variants, and all where there are several.
  std::vector<Fitted> fitted_;
};

}  // namespace tacit
