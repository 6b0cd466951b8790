#pragma once

#include <string>
#include <vector>

#include "console/record/run_store.h"
#include "console/report/table.h"
#include "deploy/experiment/battery.h"

namespace tacit {

/// A table of an experiment's report.
struct ReportTable {
  std::string name;  ///< "cells", "improvement" or "comparison".
  Table table;
};

/// The tables of an experiment, over the runs that `store` holds of it:
/// - "cells": every measure, averaged per cell, with 95 % intervals;
/// - "improvement": P(n) / (n P(1)) of the mean death distance, where the battery has teams of one
///   (paper, section 2, Figure 1);
/// - "comparison": differences between the values of the factor `compare`, run by run on the same
///   seed, with Holm's correction over the table; where the battery has such a factor.
[[nodiscard]] std::vector<ReportTable> summarize(const Battery& battery, const RunStore& store);

}  // namespace tacit
