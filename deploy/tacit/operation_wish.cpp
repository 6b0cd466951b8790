#include "deploy/tacit/operation_wish.h"

#include <charconv>
#include <cmath>

#include "console/record/files.h"
#include "console/record/record_error.h"
#include "deploy/lockstep/compose_operation.h"
#include "deploy/lockstep/operation_setup.h"
#include "deploy/tacit/scenario_library.h"
#include "idl/scenario/values.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

NamedText read_text(const fs::path& file) {
  try {
    return {read_whole_file(file.string()), file.string()};
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
}

/// "x,y" or "x,y,heading" as a row; the heading is 0 by default.
std::vector<double> start_row(std::string_view text, const char* option) {
  std::vector<double> row;
  for (std::string_view rest = text; row.size() < 4;) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    double value = 0.0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + end, value);
    if (error != std::errc() || stop != rest.data() + end || !std::isfinite(value)) break;
    row.push_back(value);
    if (end == rest.size()) {
      if (row.size() == 2) row.push_back(0.0);
      if (row.size() == 3) return row;
      break;
    }
    rest.remove_prefix(end + 1);
  }
  throw ConfigError(std::string(option) + ": found \"" + std::string(text) +
                    "\", wanted x,y in m, and perhaps a heading in degrees");
}

std::vector<std::vector<double>> start_rows(const std::vector<std::string>& texts,
                                            const char* option) {
  std::vector<std::vector<double>> rows;
  for (const std::string& text : texts) rows.push_back(start_row(text, option));
  return rows;
}

std::size_t count_of(const std::string& text) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error == std::errc() && end == text.data() + text.size() && count >= 1 && count <= 1024) {
    return count;
  }
  throw ConfigError("--robots: found \"" + text + "\", wanted a number from 1 to 1024");
}

OperationWish operation_wish(const RunWish& wish) {
  if (wish.map.empty()) {
    throw ConfigError("a mission needs a map to be carried out on: wanted --map FILE.ovl");
  }
  OperationWish operation;
  operation.mission = read_text(find_shipped(wish.scenario, "missions", ".cdl"));
  operation.map = read_text(find_shipped(wish.map, "maps", ".ovl"));
  if (!wish.robots.empty()) operation.robots = count_of(wish.robots);
  if (!wish.extra.empty()) {
    operation.extras = read_text(find_shipped(wish.extra, "missions", ".cdl"));
  }
  operation.extra_colour = wish.extra_colour;
  operation.starts = start_rows(wish.starts, "--start");
  operation.extra_starts = start_rows(wish.extra_starts, "--extra-start");
  return operation;
}

/// Numbers as TOML has them: [[1.0, 2.0, 90.0]].
std::string toml_rows(const std::vector<std::vector<double>>& rows) {
  std::string text = "[";
  for (const std::vector<double>& row : rows) {
    text += text.size() > 1 ? ", [" : "[";
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? ", " : "") + toml_number(row[i]);
    text += "]";
  }
  return text + "]";
}

}  // namespace

bool asks_for_mission(const RunWish& wish) { return wish.scenario.ends_with(".cdl"); }

ScenarioFile operation_scenario(const RunWish& wish) {
  const OperationWish operation = operation_wish(wish);
  const OperationScript script = compose_operation(operation);
  const std::string name = fs::path(operation.mission.name).stem().string();
  const std::string text =
      "[scenario]\nname = " + toml_string(name) + "\ndescription = " +
      toml_string("The mission " + operation.mission.name + " on the map " + operation.map.name) +
      "\nmission = \"operation\"\n[run]\nduration_s = " + toml_number(kOperation_s) +
      "\n[robots]\ncount = " + std::to_string(script.starts.size()) +
      "\n[operation]\nmission = " + toml_string(script.mission) +
      "\nextras = " + toml_string(script.extras) +
      "\nextra_count = " + std::to_string(script.extra_count) +
      "\nextra_colour = " + toml_string(script.extra_colour) +
      "\nmap = " + toml_string(script.map) + "\nstarts = " + toml_rows(script.starts) + "\n";
  return ScenarioFile::parse(text, operation.mission.name);
}

}  // namespace tacit
