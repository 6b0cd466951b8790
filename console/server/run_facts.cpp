#include "console/server/run_facts.h"

#include "console/record/files.h"
#include "idl/scenario/document.h"
#include "idl/types/config_error.h"

namespace tacit {

double tick_s_of(const RunDirectory& directory) {
  const std::string file = directory.scenario_file().string();
  Document document(read_whole_file(file), file);
  document.open("physics");
  const auto found = document.find("physics", "tick_s");
  const auto* value = found ? std::get_if<double>(&found->value) : nullptr;
  if (value == nullptr || !(*value > 0.0)) {
    throw ConfigError(file + ": [physics] tick_s: wanted a time above 0");
  }
  return *value;
}

}  // namespace tacit
