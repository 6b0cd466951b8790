#pragma once

#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "console/metrics/enemies.h"
#include "console/metrics/forage.h"
#include "console/metrics/idle_spread.h"
#include "console/metrics/incidents.h"
#include "console/metrics/metric.h"
#include "console/metrics/operation.h"
#include "idl/types/event.h"

namespace tacit {

/// All that is counted in a run. A fold has `add(const Event&)` and `metrics()`; one more metric
/// is one more line here.
class Tally {
 public:
  using Folds = std::tuple<Forage,         //
                           Operation,      //
                           Enemies,        //
                           DeathDistance,  //
                           Decoys,         //
                           Collisions,     //
                           Absences,       //
                           IdleSpread,     //
                           Length>;

  /// Events in the order of the log, each once.
  void add(const Event& event);

  template <class Fold>
  [[nodiscard]] const Fold& of() const {
    return std::get<Fold>(folds_);
  }

  /// In the order of the folds; those that mean nothing in this run's mission are left out.
  [[nodiscard]] std::vector<Metric> metrics() const;
  /// The value of the metric `key`; absent also when there is no such metric.
  [[nodiscard]] std::optional<double> value(std::string_view key) const;

 private:
  Folds folds_;
};

}  // namespace tacit
