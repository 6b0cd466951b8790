#pragma once

#include <span>
#include <vector>

#include "idl/types/ids.h"
#include "world_server/world/physics.h"

namespace tacit {

/// Tells new contacts from lasting ones.
///
/// Two bodies that press on each other part and touch again every few steps; a contact is new only
/// when the pair has been apart for `kApartTicks`.
class ContactLog {
 public:
  static constexpr Tick kApartTicks = 10;

  /// The contacts of `now` that are new at `tick`, in order; valid until the next call.
  [[nodiscard]] std::span<const Contact> begun(std::span<const Contact> now, Tick tick);

 private:
  struct Entry {
    Contact contact;
    Tick last = 0;
  };
  std::vector<Entry> recent_;  ///< Sorted by contact.
  std::vector<Entry> merged_;
  std::vector<Contact> begun_;
};

}  // namespace tacit
