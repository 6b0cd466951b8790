#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "console/record/files.h"
#include "console/record/record_error.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/map_picture.h"
#include "deploy/tacit/map_text.h"
#include "deploy/tacit/say.h"
#include "idl/overlay/check.h"
#include "idl/overlay/office.h"
#include "idl/overlay/reader.h"
#include "idl/overlay/writer.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit map check building.ovl                  what is wrong with it
  tacit map format building.ovl --write         every statement in one form, comments kept
  tacit map show building.ovl --out building.svg
  tacit map show building.ovl --text
  tacit map generate --seed 7 --rooms 6 -o office.ovl
  tacit run guard --map building.ovl

Exit codes: 0 good, 2 the map has errors or cannot be read. docs/maps.md describes the format.)";

struct MapWish {
  std::string file;
  std::string out;
  bool json = false;
  bool write = false;
  bool text = false;
  std::uint64_t seed = 1;
  OfficeConfig office;
};

OverlayReading read_map(const std::string& file) {
  try {
    return read_overlay(read_whole_file(file));
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
}

/// Of reading and of meaning, in order of place.
MapFindings all_findings(const OverlayReading& reading) {
  MapFindings all = reading.findings;
  const MapFindings meant = check(reading.map);
  all.insert(all.end(), meant.begin(), meant.end());
  std::stable_sort(all.begin(), all.end(), [](const MapFinding& a, const MapFinding& b) {
    return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
  });
  return all;
}

std::string to_json(const MapFindings& findings, const std::string& file) {
  nlohmann::json list = nlohmann::json::array();
  for (const MapFinding& finding : findings) {
    list.push_back({{"file", file},
                    {"line", finding.at.line},
                    {"column", finding.at.column},
                    {"severity", finding.severity == Severity::Error ? "error" : "warning"},
                    {"text", finding.text}});
  }
  return list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

Exit check_map(const MapWish& wish) {
  const OverlayReading reading = read_map(wish.file);
  const MapFindings findings = all_findings(reading);
  if (wish.json) {
    std::cout << to_json(findings, wish.file) << '\n';
  } else {
    for (const MapFinding& finding : findings) {
      std::cout << to_text(finding, wish.file) << '\n';
    }
    std::cout << wish.file << ": " << reading.map.statements.size() << " statements, "
              << findings.size() << (findings.size() == 1 ? " finding\n" : " findings\n");
  }
  return has_errors(findings) ? Exit::BadInput : Exit::Done;
}

Exit format_map(const MapWish& wish) {
  const OverlayReading reading = read_map(wish.file);
  refuse_errors(reading.findings, wish.file);
  const std::string text = to_canonical_text(reading.map);
  if (wish.write) {
    write_whole_file(wish.file, text);
  } else {
    std::cout << text;
  }
  return Exit::Done;
}

void put_out(const std::string& text, const MapWish& wish, const std::string& deed) {
  if (wish.out.empty()) {
    std::cout << text;
  } else {
    write_whole_file(wish.out, text);
    say(deed + " to " + wish.out);
  }
}

Exit show_map(const MapWish& wish) {
  constexpr int kColumns = 100;
  const OverlayReading reading = read_map(wish.file);
  refuse_errors(reading.findings, wish.file);
  put_out(wish.text ? text_picture_of(reading.map, kColumns) : picture_of(reading.map), wish,
          "drew " + wish.file);
  return Exit::Done;
}

Exit generate_map(const MapWish& wish) {
  put_out(to_text(random_office(wish.seed, wish.office)), wish,
          "wrote an office building of seed " + std::to_string(wish.seed));
  return Exit::Done;
}

using Work = Exit (*)(const MapWish&);

CLI::App* add(CLI::App& map, Exit& ending, const std::shared_ptr<MapWish>& wish,
              const std::pair<const char*, const char*>& name_and_doc, Work work) {
  CLI::App* command = map.add_subcommand(name_and_doc.first, name_and_doc.second);
  command->add_option("file", wish->file, "A MissionLab overlay")
      ->required()
      ->type_name("FILE.ovl");
  command->callback([wish, work, &ending] { ending = work(*wish); });
  return command;
}

void add_generate(CLI::App& map, Exit& ending, const std::shared_ptr<MapWish>& wish) {
  CLI::App* command = map.add_subcommand("generate", "Make an office building by chance");
  command->add_option("--seed", wish->seed, "The same seed gives the same building")
      ->required()
      ->type_name("N");
  command->add_option("--rooms", wish->office.rooms, "2 to 8; else 4 to 8 by chance")
      ->type_name("N");
  command->add_option("--closed", wish->office.closed_rooms, "So many of them without a door")
      ->type_name("N");
  command->add_option("--suspects", wish->office.suspects, "Suspect objects, one of them real")
      ->type_name("N");
  command->add_flag("!--no-sentry", wish->office.sentry, "No yard and no sentry's way");
  command->add_flag("--approach", wish->office.approach,
                    "Begin outside, with way points to a way into the building");
  command->add_option("-o,--out", wish->out, "File to make; else it is printed")
      ->type_name("FILE.ovl");
  command->callback([wish, &ending] { ending = generate_map(*wish); });
}

}  // namespace

void add_map(CLI::App& app, Exit& ending) {
  CLI::App* map =
      app.add_subcommand("map", "Check, format, draw and make maps (MissionLab overlays)");
  map->require_subcommand(1);
  map->footer(kExamples);
  const auto wish = std::make_shared<MapWish>();
  add(*map, ending, wish, {"check", "Tell errors and what looks odd"}, check_map)
      ->add_flag("--json", wish->json, "As JSON");
  add(*map, ending, wish, {"format", "Print it with every statement in one form"}, format_map)
      ->add_flag("--write", wish->write, "Into the file itself");
  CLI::App* show = add(*map, ending, wish, {"show", "Draw it as SVG or in letters"}, show_map);
  show->add_option("-o,--out", wish->out, "File to make; else it is printed")
      ->type_name("FILE.svg");
  show->add_flag("--text", wish->text, "In letters");
  add_generate(*map, ending, wish);
}

}  // namespace tacit
