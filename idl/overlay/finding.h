#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "idl/overlay/overlay.h"

namespace tacit {

enum class Severity : std::uint8_t { Warning, Error };

/// Something about a map that its author should know.
struct MapFinding {
  Severity severity = Severity::Error;
  MapSpot at;
  std::string text;  ///< "found ..., wanted ...", with a hint where there is one.
  friend bool operator==(const MapFinding&, const MapFinding&) = default;
};

using MapFindings = std::vector<MapFinding>;

/// "file:line:col: error: text".
[[nodiscard]] std::string to_text(const MapFinding& finding, const std::string& file);

[[nodiscard]] bool has_errors(const MapFindings& findings);

/// Throws ConfigError, a line for each error of `file`, when there is one.
void refuse_errors(const MapFindings& findings, const std::string& file);

}  // namespace tacit
