#include "robot_agent/brain/learning/role_selector.h"

#include "idl/types/config_error.h"

namespace tacit {

std::string RoleSelector::policy() const { return R"({"learner":")" + learner_ + R"("})"; }

void RoleSelector::inherit(std::string_view policy, std::string_view name) {
  if (policy == this->policy()) return;
  throw ConfigError(std::string(name) + ": is not a policy of learner " + learner_ + ": found " +
                    std::string(policy.substr(0, 60)) + ", wanted " + this->policy());
}

bool RoleSelector::resume(const RunStand& /*stand*/, std::string_view policy) {
  return policy == this->policy();
}

}  // namespace tacit
