#include "robot_agent/brain/assemblage/assemblage.h"

namespace tacit {

Assemblage::Assemblage(const SchemaConfigs& configs, const Self& self, const Gains& ceiling) {
  for_each_schema([&]<class S>() {
    if (ceiling.of<S>() == 0.0) return;
    members_.push_back({S::kName, kSchemaIndex<S>, make_schema<S>(configs, self), 0.0, {}});
  });
}

BodyVec Assemblage::sum(const Surroundings& around, const Gains& gains) {
  BodyVec total;
  for (Member& member : members_) {
    member.gain = gains.value[member.index];
    member.push = member.schema->push(around);
    total += member.gain * member.push;
  }
  return total;
}

void Assemblage::report(std::vector<SchemaShare>& shares) const {
  shares.resize(members_.size());
  for (std::size_t i = 0; i < members_.size(); ++i) {
    shares[i].name = members_[i].name;
    shares[i].gain = members_[i].gain;
    shares[i].push = members_[i].push;
  }
}

}  // namespace tacit
