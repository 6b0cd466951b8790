#include "console/gateway/sessions.h"

#include <algorithm>
#include <stdexcept>

namespace tacit::gateway {
namespace {

bool is_id(std::string_view id) {
  return !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  });
}

template <typename States>
auto position(States& states, std::string_view id) {
  return std::find_if(states.begin(), states.end(),
                      [&](const auto& state) { return state->id() == id; });
}

}  // namespace

Sessions::StatePtr Sessions::open(const std::string& id, const std::string& name,
                                  const Limits& limits, const std::shared_ptr<Tally>& tally) {
  if (!is_id(id)) {
    throw std::invalid_argument("no id of a session: " + id);
  }
  const std::scoped_lock lock(mutex_);
  if (position(states_, id) != states_.end()) {
    throw std::invalid_argument("there is such a session already: " + id);
  }
  return states_.emplace_back(std::make_shared<SessionState>(id, name, limits, tally));
}

void Sessions::close(std::string_view id) {
  StatePtr closed;
  {
    const std::scoped_lock lock(mutex_);
    const auto at = position(states_, id);
    if (at == states_.end()) {
      return;
    }
    closed = *at;
    states_.erase(at);
  }
  closed->close();
}

void Sessions::mark_newest(std::string_view id) {
  const std::scoped_lock lock(mutex_);
  const auto at = position(states_, id);
  if (at != states_.end()) {
    std::rotate(at, at + 1, states_.end());
  }
}

Sessions::StatePtr Sessions::at(const std::vector<std::string>& parts) const {
  if (parts.size() == 2 && parts[0] == "ws") {
    return find(parts[1]);
  }
  const bool is_newest = parts.size() == 1 && (parts[0] == "ws" || parts[0].empty());
  return is_newest ? newest() : nullptr;
}

Sessions::StatePtr Sessions::find(std::string_view id) const {
  const std::scoped_lock lock(mutex_);
  const auto at = position(states_, id);
  return at == states_.end() ? nullptr : *at;
}

Sessions::StatePtr Sessions::newest() const {
  const std::scoped_lock lock(mutex_);
  return states_.empty() ? nullptr : states_.back();
}

}  // namespace tacit::gateway
