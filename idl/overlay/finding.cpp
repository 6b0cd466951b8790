#include "idl/overlay/finding.h"

#include <algorithm>

#include "idl/types/config_error.h"

namespace tacit {

std::string to_text(const MapFinding& finding, const std::string& file) {
  std::string place = file;
  if (finding.at.line > 0) {
    place += ':' + std::to_string(finding.at.line) + ':' + std::to_string(finding.at.column);
  }
  const bool error = finding.severity == Severity::Error;
  return place + (error ? ": error: " : ": warning: ") + finding.text;
}

bool has_errors(const MapFindings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const MapFinding& finding) { return finding.severity == Severity::Error; });
}

void refuse_errors(const MapFindings& findings, const std::string& file) {
  std::string text;
  for (const MapFinding& finding : findings) {
    if (finding.severity == Severity::Error) {
      text += (text.empty() ? "" : "\n") + to_text(finding, file);
    }
  }
  if (!text.empty()) {
    throw ConfigError(text);
  }
}

}  // namespace tacit
