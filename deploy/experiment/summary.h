#pragma once

#include <vector>

#include "console/record/run_store.h"
#include "console/report/table.h"
#include "deploy/experiment/battery.h"

namespace tacit {

/// The tables of an experiment, over the runs that `store` holds of it:
/// - "cells": every measure, averaged per cell, with 95 % intervals;
/// - "improvement": P(n) / (n P(1)) of the mean death distance, where the battery has teams of one
///   (paper, section 2, Figure 1);
/// - "comparison": differences between the values of the factor `compare`, run by run on the same
///   seed, with Holm's correction over the table.
[[nodiscard]] std::vector<Table> summarize(const Battery& battery, const RunStore& store);

}  // namespace tacit
