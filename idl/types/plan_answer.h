#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "idl/types/plan_request.h"

namespace tacit {

/// How one feature of a case fits what was looked for.
struct FeatureMatch {
  std::string feature;  ///< "NumberOfRobots".
  std::string wanted;   ///< Empty: left open.
  std::string found;
  bool matches = true;
  friend bool operator==(const FeatureMatch&, const FeatureMatch&) = default;
};

/// A case that a plan is made from.
struct UsedCase {
  CaseId id = 0;
  std::string title;
  std::size_t task = 0;  ///< Index of the request's task that it is for.
  std::vector<FeatureMatch> features;
  std::string record;  ///< "9 of 10 outcomes good; last failure: …"; empty without one.
  friend bool operator==(const UsedCase&, const UsedCase&) = default;
};

/// What was changed on the way from the cases to the plan, or found and left.
struct PlanChange {
  enum class Step : std::uint8_t { Adapt, Criticize };
  Step step = Step::Adapt;
  std::string rule;    ///< In one word: "unreachable-goal".
  std::string why;     ///< A sentence.
  std::string before;  ///< May be empty.
  std::string after;   ///< Empty when nothing could be changed.
  bool mended = true;  ///< False: it is likely to go wrong.
  friend bool operator==(const PlanChange&, const PlanChange&) = default;
};

/// A plan that can be run as it is.
struct OfferedPlan {
  double stars = 0.0;       ///< 0 to 5.
  std::string arrangement;  ///< "Every robot does every task, in order."
  std::string mission;      ///< In CDL.
  std::vector<UsedCase> cases;
  std::vector<PlanChange> changes;
  friend bool operator==(const OfferedPlan&, const OfferedPlan&) = default;
};

/// Work is under way.
struct WizardProgress {
  double done = 0.0;  ///< 0 to 1.
  std::string doing;
  friend bool operator==(const WizardProgress&, const WizardProgress&) = default;
};
/// The plans for AskForPlans.
struct PlanAnswer {
  std::vector<OfferedPlan> plans;  ///< Best first.
  std::vector<std::string> notes;  ///< What a person should know beside: sentences.
  friend bool operator==(const PlanAnswer&, const PlanAnswer&) = default;
};
/// The others are done.
struct WizardDone {
  std::uint64_t cases = 0;  ///< In the case base now.
  std::string text;         ///< What was done: "Stored 2 new cases; 1 was there."
  friend bool operator==(const WizardDone&, const WizardDone&) = default;
};
/// It cannot be done.
struct WizardRefusal {
  std::string text;  ///< What was found and what was wanted, one a line.
  friend bool operator==(const WizardRefusal&, const WizardRefusal&) = default;
};

/// What the wizard says to a request: progress any number of times, then one of the others.
struct WizardReply {
  std::uint64_t client = 0;
  std::uint64_t number = 0;
  std::variant<WizardProgress, PlanAnswer, WizardDone, WizardRefusal> what;
  friend bool operator==(const WizardReply&, const WizardReply&) = default;
};

}  // namespace tacit
