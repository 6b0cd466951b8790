#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "idl/cdl/check.h"
#include "idl/cdl/diagram.h"
#include "idl/cdl/resolve.h"
#include "tests/cdl/laws.h"

namespace tacit::cdl {
namespace {

void insist(bool truth, const char* what) {
  if (!truth) {
    std::fprintf(stderr, "broken law: %s\n", what);
    std::abort();
  }
}

void keeps_the_laws(std::string_view text) {
  const std::string broken = broken_law(text);
  insist(broken.empty(), broken.c_str());
}

/// What is left of a mission with errors is checked, resolved and drawn as well.
void is_used(std::string_view text) {
  const Parsed parsed = parse(text);
  for (const Finding& finding : check(parsed.mission, text)) {
    insist(finding.offset <= text.size(), "findings lie in the text");
  }
  const Box team = diagram_of(resolve(parsed.mission).robots);
  insist(!to_mermaid(team).empty() && !to_dot(team).empty() && !to_scxml(team).empty(),
         "every team can be drawn");
}

/// An edit changes what was edited and nothing else.
void takes_an_edit(std::string_view text) {
  Parsed parsed = parse(text);
  if (!parsed.findings.empty()) {
    return;
  }
  Mission& mission = parsed.mission;
  for (Statement& statement : mission.statements) {
    if (!statement.body.items.empty() && statement.body.kind != Expression::Kind::Rule) {
      statement.body.items.pop_back();
      statement.body.place = Place{1.0, 2.0};
    }
  }
  const Parsed again = parse(print(mission, text));
  insist(again.findings.empty() && again.mission == mission, "what was edited can be read again");
}

}  // namespace
}  // namespace tacit::cdl

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  tacit::cdl::keeps_the_laws(text);
  tacit::cdl::is_used(text);
  tacit::cdl::takes_an_edit(text);
  return 0;
}
