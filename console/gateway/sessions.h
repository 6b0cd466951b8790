#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "console/gateway/session_state.h"

namespace tacit::gateway {

/// The sessions that are open. From any thread.
class Sessions {
 public:
  using StatePtr = std::shared_ptr<SessionState>;

  /// Throws std::invalid_argument when the id is open already or has other characters than
  /// letters, digits, `-`, `_` and `.`.
  StatePtr open(const std::string& id, const std::string& name, const Limits& limits,
                const std::shared_ptr<Tally>& tally);
  void close(std::string_view id);
  void mark_newest(std::string_view id);
  /// At the path /ws/ID that of the id, at /ws and / the newest; null when there is none.
  [[nodiscard]] StatePtr at(const std::vector<std::string>& parts) const;

 private:
  StatePtr find(std::string_view id) const;
  StatePtr newest() const;

  mutable std::mutex mutex_;
  std::vector<StatePtr> states_;  ///< The newest last.
};

}  // namespace tacit::gateway
