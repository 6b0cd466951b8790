#pragma once

#include <string>
#include <vector>

#include "console/record/run_store.h"
#include "console/report/table.h"
#include "deploy/experiment/battery.h"

namespace tacit {

/// A table of an experiment's report.
struct ReportTable {
  std::string name;  ///< As listed at `summarize`.
  Table table;
};

/// A figure of an experiment's report.
struct ReportFigure {
  std::string name;  ///< "team_size" or "curve".
  std::string svg;
};

/// The tables of an experiment, over the runs that `store` holds of it; one without rows is left
/// out:
/// - "cells": every measure, averaged per cell, with 95 % intervals; of chains also `failed`;
/// - "improvement": P(n) / (n P(1)) of the mean death distance, where the battery has teams of one
///   (paper, section 2, Figure 1);
/// - "comparison": differences between the values of the factor `compare`, run by run on the same
///   seed, with Holm's correction over the table; where the battery has such a factor;
/// - "team_size", "fit", "fit_band": the first measure by team size and the decay that fits it,
///   where nothing but scenarios and variants varies beside several team sizes (paper, section 3,
///   Figure 4);
/// - "variants", "effects": differences between variants, and how much of the variation they
///   account for; where there are several;
/// - "curve", "learned": the score from run to run, where runs are chains;
/// - "held_out": what was selected in training against its rivals on other seeds, where
///   `select_by` is given.
[[nodiscard]] std::vector<ReportTable> summarize(const Battery& battery, const RunStore& store);

/// The figures: "team_size" and "curve", where the tables of these names are and have a value.
[[nodiscard]] std::vector<ReportFigure> draw(const Battery& battery, const RunStore& store);

}  // namespace tacit
