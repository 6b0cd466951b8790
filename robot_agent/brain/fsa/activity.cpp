#include "robot_agent/brain/fsa/activity.h"

#include "idl/types/config_error.h"

namespace tacit {

Activity::Activity(const ActivityPlan& plan, const SchemaConfigs& configs, const Self& self)
    : act_(plan.act) {
  for (const SchemaUse& use : plan.schemas) {
    std::unique_ptr<Schema> schema = make_schema(use, configs, self);
    if (use.gain == 0.0) continue;
    members_.push_back({name(use), use.gain, std::move(schema), {}});
  }
  if (members_.size() > Telemetry::kMaxShares) {
    throw ConfigError("an activity has " + std::to_string(members_.size()) +
                      " schemas, wanted at most " + std::to_string(Telemetry::kMaxShares));
  }
}

Doing Activity::step(const Surroundings& around) {
  Doing doing{{}, act_};
  for (Member& member : members_) {
    member.push = member.schema->push(around);
    doing.sum += member.gain * member.push;
  }
  return doing;
}

void Activity::report(std::vector<SchemaShare>& shares) const {
  shares.resize(members_.size());
  for (std::size_t i = 0; i < members_.size(); ++i) {
    shares[i].name = members_[i].name;
    shares[i].gain = members_[i].gain;
    shares[i].push = members_[i].push;
  }
}

void Activity::rest() {
  for (Member& member : members_) member.push = {};
}

}  // namespace tacit
