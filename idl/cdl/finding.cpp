#include "idl/cdl/finding.h"

#include <algorithm>

#include "idl/types/config_error.h"

namespace tacit::cdl {

void FindingList::add(Finding finding) {
  std::size_t& told = finding.severity == Severity::Error ? errors_ : warnings_;
  if (told == kMostFindings) {
    finding.rule = "too-many";
    finding.text = "more than " + std::to_string(kMostFindings) + " findings, the rest is not told";
  }
  if (told <= kMostFindings) {
    findings_.push_back(std::move(finding));
    ++told;
  }
}

std::string to_text(const Finding& finding, std::string_view file) {
  std::string text(file);
  text += ':' + std::to_string(finding.line) + ':' + std::to_string(finding.column);
  text += finding.severity == Severity::Error ? ": error: " : ": warning: ";
  return text + finding.text + " [" + finding.rule + ']';
}

bool has_error(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == Severity::Error; });
}

void locate(Findings& findings, std::string_view text) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.offset < b.offset; });
  std::size_t line = 1;
  std::size_t line_begin = 0;
  std::size_t at = 0;
  for (Finding& finding : findings) {
    for (; at < finding.offset && at < text.size(); ++at) {
      if (text[at] == '\n') {
        ++line;
        line_begin = at + 1;
      }
    }
    finding.line = line;
    finding.column = at - line_begin + 1;
  }
}

void refuse_errors(Findings findings, std::string_view text, std::string_view name) {
  if (!has_error(findings)) {
    return;
  }
  locate(findings, text);
  std::string all;
  std::string last;
  for (const Finding& each : findings) {
    if (each.severity != Severity::Error) {
      continue;
    }
    std::string line = to_text(each, name);
    if (line == last) {
      continue;  // Robots that share a part share its faults.
    }
    all += (all.empty() ? "" : "\n") + line;
    last = std::move(line);
  }
  throw ConfigError(all);
}

}  // namespace tacit::cdl
