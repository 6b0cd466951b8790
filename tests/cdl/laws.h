#pragma once

#include <string>
#include <string_view>

#include "idl/cdl/parse.h"
#include "idl/cdl/print.h"

namespace tacit::cdl {

/// The first law of reading and printing that a text breaks; none when it keeps all of them.
///
/// A text without errors is printed back byte for byte, its house layout is the same mission, and
/// laying that out again changes nothing. Errors lie in the text.
inline std::string broken_law(std::string_view text) {
  const Parsed parsed = parse(text);
  for (const Finding& finding : parsed.findings) {
    if (finding.offset > text.size() || finding.line == 0 || finding.column == 0) {
      return "an error lies in the text";
    }
  }
  if (!parsed.findings.empty()) {
    return "";
  }
  if (print(parsed.mission, text) != text) {
    return "what is not edited is printed byte for byte";
  }
  const std::string laid_out = print(parsed.mission);
  const Parsed again = parse(laid_out);
  if (!again.findings.empty() || again.mission != parsed.mission) {
    return "the house layout is the same mission: " + laid_out;
  }
  return print(again.mission) == laid_out ? "" : "laying out twice is laying out once: " + laid_out;
}

}  // namespace tacit::cdl
