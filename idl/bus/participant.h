#pragma once

#include <memory>
#include <stdexcept>

#include "idl/bus/identity.h"
#include "idl/bus/rejections.h"

namespace tacit {

/// The bus could not be set up; the text says what and on which domain.
class BusError : public std::runtime_error {
 public:
  explicit BusError(const std::string& text) : std::runtime_error(text) {}
};

/// This process on the bus of one run.
///
/// The world's participant is where the others find one another: it tells each only of those it
/// shares a topic with, so agents never learn of one another. Outlives its publishers and
/// subscribers.
class Participant {
 public:
  /// Throws BusError.
  explicit Participant(const Identity& identity);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  [[nodiscard]] Rejections& rejections() { return rejections_; }

  struct Entities;
  [[nodiscard]] Entities& entities() { return *entities_; }

 private:
  Rejections rejections_;
  std::unique_ptr<Entities> entities_;
};

}  // namespace tacit
