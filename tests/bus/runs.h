#pragma once

#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "idl/bus/domain_lease.h"
#include "idl/bus/identity.h"
#include "idl/bus/leftovers.h"

namespace tacit::test {

/// A run of its own for one test: a domain that nobody else uses, and a nonce.
class Run {
 public:
  Run() : nonce_(fresh_nonce()), lease_(DomainLease::take(nonce_)) {}
  ~Run() { remove_leftovers(nonce_); }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  [[nodiscard]] std::uint32_t nonce() const { return nonce_; }
  [[nodiscard]] int domain() const { return lease_.domain(); }
  [[nodiscard]] Identity world() const { return {Party::World, {}, domain(), nonce_, 0}; }
  [[nodiscard]] Identity agent(std::uint16_t robot, std::uint32_t incarnation = 1) const {
    return {Party::Agent, {robot}, domain(), nonce_, incarnation};
  }
  [[nodiscard]] Identity console(std::uint32_t incarnation = 1) const {
    return {Party::Console, {}, domain(), nonce_, incarnation};
  }

 private:
  static std::uint32_t fresh_nonce() {
    static std::uint32_t calls = 0;
    return static_cast<std::uint32_t>(getpid()) * 64 + ++calls;
  }

  std::uint32_t nonce_;
  DomainLease lease_;
};

/// Waits until `holds`; false when that took longer than any healthy machine needs.
inline bool eventually(const std::function<bool()>& holds) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(15);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace tacit::test
