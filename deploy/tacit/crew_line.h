#pragma once

#include <string>

#include "deploy/experiment/crew.h"

namespace tacit {

/// A line on standard error that tells how far a row of jobs has come and how long it will take:
/// one that changes in place on a terminal, now and then a new one elsewhere.
class CrewLine {
 public:
  /// `what` are the jobs: "flights". A quiet one shows nothing.
  CrewLine(std::string what, bool quiet);

  void show(const CrewProgress& progress);
  /// Ends the line.
  void finish() const;

 private:
  [[nodiscard]] std::string text(const CrewProgress& progress) const;

  std::string what_;
  bool quiet_;
  bool terminal_;
  double shown_s_ = -1e9;
};

}  // namespace tacit
