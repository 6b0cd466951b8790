#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tacit::cdl {

enum class Severity { Error, Warning };

/// Something to tell the author of a mission.
struct Finding {
  Severity severity = Severity::Error;
  std::string rule;          ///< Which check, in one word: "undefined-name".
  std::string text;          ///< What was found and what was wanted.
  std::uint32_t offset = 0;  ///< Byte of the text.
  std::size_t line = 0;      ///< From 1.
  std::size_t column = 0;    ///< In bytes, from 1.
};

using Findings = std::vector<Finding>;

/// Findings of each severity that are told; a broken file of any size can have no more.
inline constexpr std::size_t kMostFindings = 1000;

/// Collects findings, not yet located. What is too much of a severity is said once and left out.
class FindingList {
 public:
  void add(Finding finding);
  [[nodiscard]] std::size_t size() const { return findings_.size(); }
  [[nodiscard]] Findings take() { return std::move(findings_); }

 private:
  Findings findings_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
};

/// "file:line:column: error: text [rule]".
[[nodiscard]] std::string to_text(const Finding& finding, std::string_view file);

[[nodiscard]] bool has_error(const Findings& findings);

/// Sets line and column of each from its offset in `text`, and sorts them by offset.
void locate(Findings& findings, std::string_view text);

/// Throws ConfigError when there is an error among `findings`: all of them, one a line, those that
/// say the same of one place once. `text` is what they are about, `name` what it is called.
void refuse_errors(Findings findings, std::string_view text, std::string_view name);

}  // namespace tacit::cdl
