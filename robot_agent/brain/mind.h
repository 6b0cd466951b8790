#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "idl/types/command.h"
#include "idl/types/percept.h"
#include "idl/types/telemetry.h"

namespace tacit {

/// How a brain thinks in one kind of mission; the functions are those of `Brain`.
class Mind {
 public:
  virtual ~Mind() = default;
  [[nodiscard]] virtual Command decide(const Percept& percept) = 0;
  virtual void report(Telemetry& out) const = 0;
  [[nodiscard]] virtual std::string memory(std::string_view policy) const = 0;
  [[nodiscard]] virtual bool recall(std::string_view memory) = 0;
  [[nodiscard]] virtual std::uint64_t lessons() const = 0;
  [[nodiscard]] virtual std::string policy() const = 0;
  virtual void inherit(std::string_view policy, std::string_view name) = 0;
};

}  // namespace tacit
