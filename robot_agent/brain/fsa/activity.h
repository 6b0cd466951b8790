#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/fsa/behaviour.h"
#include "robot_agent/brain/fsa/schema_use.h"

namespace tacit {

/// A behavioural assemblage with fixed gains, and an act that goes with it.
class Activity final : public Behaviour {
 public:
  /// Leaves out schemas with gain 0. Throws ConfigError as `make_schema` does, and when there are
  /// more schemas than telemetry can show.
  Activity(const ActivityPlan& plan, const SchemaConfigs& configs, const Self& self);

  void enter(const Entry& entry) override;
  [[nodiscard]] Doing step(const Surroundings& around) override;
  void report(std::vector<SchemaShare>& shares) const override;
  [[nodiscard]] std::span<const Word> exit() const override { return exit_; }
  void note(Record& record) const override { record.add(entry_); }
  [[nodiscard]] bool resume(RecordReader& record) override;

 private:
  struct Member {
    std::string name;
    double gain = 0.0;
    std::unique_ptr<Schema> schema;
    BodyVec push;  ///< In the last step.
  };
  [[nodiscard]] bool acts(Tick now) const;

  std::vector<Member> members_;
  Deed deed_;
  Turn turn_;
  std::vector<Word> exit_;
  Entry entry_;
};

}  // namespace tacit
