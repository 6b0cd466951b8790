#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "console/record/files.h"
#include "console/record/record_error.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/say.h"
#include "idl/cdl/check.h"
#include "idl/cdl/diagram.h"
#include "idl/cdl/parse.h"
#include "idl/cdl/print.h"
#include "idl/cdl/resolve.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit mission check patrol.cdl                  all that is wrong with it, by line
  tacit mission check --json patrol.cdl
  tacit mission format --write patrol.cdl         the house layout, comments kept
  tacit mission show patrol.cdl                   robots and their automata, for Mermaid
  tacit mission show --as dot patrol.cdl | dot -Tsvg > patrol.svg

A FILE is a mission in MissionLab's Configuration Description Language; docs/missions.md describes
what is read.)";

struct MissionWish {
  std::string file;
  std::string as = "mermaid";
  bool json = false;
  bool write = false;
};

std::string read_mission(const MissionWish& wish) {
  try {
    return read_whole_file(wish.file);
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
}

nlohmann::json to_json(const cdl::Finding& finding) {
  return {{"severity", finding.severity == cdl::Severity::Error ? "error" : "warning"},
          {"rule", finding.rule},
          {"line", finding.line},
          {"column", finding.column},
          {"text", finding.text}};
}

void print_json(const cdl::Findings& findings, const std::string& file) {
  nlohmann::json list = nlohmann::json::array();
  for (const cdl::Finding& finding : findings) {
    list.push_back(to_json(finding));
  }
  const nlohmann::json all{{"file", file}, {"ok", !has_error(findings)}, {"findings", list}};
  // Names in a file need not be UTF-8.
  std::cout << all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void print_lines(const cdl::Findings& findings, const std::string& file) {
  for (const cdl::Finding& finding : findings) {
    std::cout << cdl::to_text(finding, file) << '\n';
  }
  if (findings.empty()) {
    std::cout << file << ": nothing to say\n";
  }
}

Exit check_mission(const MissionWish& wish) {
  const cdl::Findings findings = cdl::check_text(read_mission(wish));
  if (wish.json) {
    print_json(findings, wish.file);
  } else {
    print_lines(findings, wish.file);
  }
  return has_error(findings) ? Exit::BadInput : Exit::Done;
}

/// Throws ConfigError with every error of the language.
cdl::Mission parsed_mission(const std::string& text, const std::string& file) {
  cdl::Parsed parsed = cdl::parse(text);
  std::string errors;
  for (const cdl::Finding& finding : parsed.findings) {
    errors += (errors.empty() ? "" : "\n") + cdl::to_text(finding, file);
  }
  if (!errors.empty()) {
    throw ConfigError(errors);
  }
  return std::move(parsed.mission);
}

/// Behind a link the file itself is replaced; who may read it stays.
void replace(const std::string& file, const std::string& text) {
  const std::filesystem::path target = std::filesystem::canonical(file);
  const std::filesystem::perms rights = std::filesystem::status(target).permissions();
  write_whole_file(target, text);
  std::filesystem::permissions(target, rights);
}

Exit format_mission(const MissionWish& wish) {
  const std::string text = read_mission(wish);
  const std::string formatted = print(parsed_mission(text, wish.file));
  if (!wish.write) {
    std::cout << formatted;
  } else if (formatted != text) {
    replace(wish.file, formatted);
    say("wrote " + wish.file);
  }
  return Exit::Done;
}

Exit show_mission(const MissionWish& wish) {
  const std::string text = read_mission(wish);
  cdl::Resolved resolved = resolve(parsed_mission(text, wish.file));
  locate(resolved.findings, text);
  for (const cdl::Finding& finding : resolved.findings) {
    say(cdl::to_text(finding, wish.file));
  }
  const cdl::Box team = diagram_of(resolved.robots);
  if (team.inside.empty()) {
    throw ConfigError(wish.file + ": has no robots to show");
  }
  std::cout << (wish.as == "dot"     ? to_dot(team)
                : wish.as == "scxml" ? to_scxml(team)
                                     : to_mermaid(team));
  return Exit::Done;
}

using Work = Exit (*)(const MissionWish&);

CLI::App* add(CLI::App& mission, Exit& ending, const std::shared_ptr<MissionWish>& wish,
              const std::pair<const char*, const char*>& name_and_doc, Work work) {
  CLI::App* command = mission.add_subcommand(name_and_doc.first, name_and_doc.second);
  command->add_option("file", wish->file, "Mission (.cdl)")->required()->type_name("FILE");
  command->callback([wish, work, &ending] { ending = work(*wish); });
  command->footer(kExamples);
  return command;
}

}  // namespace

void add_mission(CLI::App& app, Exit& ending) {
  CLI::App* mission = app.add_subcommand("mission", "Check, format and draw missions");
  mission->require_subcommand(1);
  mission->footer(kExamples);
  const auto wish = std::make_shared<MissionWish>();
  add(*mission, ending, wish, {"check", "Print all that is wrong; exit code 2 with an error"},
      check_mission)
      ->add_flag("--json", wish->json, "As JSON");
  add(*mission, ending, wish, {"format", "Print in the house layout"}, format_mission)
      ->add_flag("--write", wish->write, "Replace the file instead");
  add(*mission, ending, wish, {"show", "Print robots and their automata as a drawing"},
      show_mission)
      ->add_option("--as", wish->as, "Language of the drawing")
      ->check(CLI::IsMember({"dot", "mermaid", "scxml"}))
      ->capture_default_str();
}

}  // namespace tacit
