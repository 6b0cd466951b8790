#include "robot_agent/brain/fsa/activity.h"

#include "idl/types/config_error.h"

namespace tacit {
namespace {

/// How far a robot that faces `now` is from having turned once about-face since `start`, by the
/// shorter way; counter-clockwise where both are as short.
double rest_of_about_face(const Heading& start, const Heading& now) {
  const double cos = -(start.cos * now.cos + start.sin * now.sin);
  const double sin = start.cos * now.sin - start.sin * now.cos;
  return arc_tangent(sin, cos);
}

}  // namespace

Activity::Activity(const ActivityPlan& plan, const SchemaConfigs& configs, const Self& self)
    : deed_(plan.deed), turn_(plan.turn), exit_(plan.exit) {
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

void Activity::enter(const Entry& entry) {
  entry_ = entry;
  for (Member& member : members_) {
    member.push = {};
    member.schema->enter();
  }
}

Doing Activity::step(const Surroundings& around) {
  Doing doing;
  for (Member& member : members_) {
    member.push = member.schema->push(around);
    doing.add(member.gain, member.push);
  }
  if (acts(around.tick)) {
    doing.act = deed_.act;
    doing.about = deed_.about;
    doing.word = deed_.word;
  }
  if (turn_ == Turn::AboutFace) {
    doing.turn_rad = rest_of_about_face(entry_.pose.heading, around.odometry.heading);
  } else if (turn_ == Turn::Scan) {
    doing.turn_rad = 0.5 * kPi;
  }
  return doing;
}

bool Activity::acts(Tick now) const {
  const Tick begin = entry_.tick + deed_.after_ticks;
  return deed_.once ? now == begin + 1 : now >= begin;
}

void Activity::report(std::vector<SchemaShare>& shares) const {
  shares.resize(members_.size());
  for (std::size_t i = 0; i < members_.size(); ++i) {
    shares[i].name = members_[i].name;
    shares[i].gain = members_[i].gain;
    shares[i].push = members_[i].push;
  }
}

bool Activity::resume(RecordReader& record) {
  const Entry entry = record.entry();
  if (!record.sound()) return false;
  enter(entry);
  return true;
}

}  // namespace tacit
