#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include "idl/bus/lock_file.h"

namespace tacit {

/// A DDS domain for one run alone, so that several runs on one host never hear each other.
///
/// The lease is a lock on a file, which the kernel lets go of however the holder ends. A holder
/// that was killed leaves its run's nonce in the file; whoever takes the domain next removes what
/// that run left in shared memory.
class DomainLease {
 public:
  static constexpr int kFirst = 1;
  static constexpr int kLast = 100;

  /// Takes the first free domain. A domain whose discovery port is in use, perhaps by another user,
  /// is not free. Throws BusError when none is, or when `folder` cannot be used.
  [[nodiscard]] static DomainLease take(std::uint32_t run_nonce,
                                        const std::filesystem::path& folder = lease_folder());
  ~DomainLease();
  DomainLease(DomainLease&& other) noexcept
      : domain_(other.domain_), file_(std::exchange(other.file_, -1)) {}
  DomainLease& operator=(DomainLease&&) = delete;

  [[nodiscard]] int domain() const { return domain_; }

 private:
  DomainLease(int domain, int file) : domain_(domain), file_(file) {}

  int domain_;
  int file_;
};

}  // namespace tacit
