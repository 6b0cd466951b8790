#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tacit {

/// Notices within one look that processes of this host have ended, however they did.
class ProcessWatch {
 public:
  /// Watches `slots` processes at most.
  explicit ProcessWatch(std::size_t slots);
  ~ProcessWatch();
  ProcessWatch(const ProcessWatch&) = delete;
  ProcessWatch& operator=(const ProcessWatch&) = delete;

  /// Watches process `pid` of `host` in `slot`, in place of what was watched there. A process of
  /// another host cannot be watched and never counts as ended.
  void watch(std::size_t slot, std::int32_t pid, const std::string& host);
  void forget(std::size_t slot);

  /// Whether the process in `slot` had ended at the last `look`.
  [[nodiscard]] bool ended(std::size_t slot) const { return ended_[slot]; }
  void look();

 private:
  std::vector<int> files_;  ///< A pidfd for each slot; -1 when none.
  std::vector<bool> ended_;
};

}  // namespace tacit
