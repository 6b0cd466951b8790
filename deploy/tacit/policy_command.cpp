#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "console/record/files.h"
#include "console/record/policy_folder.h"
#include "console/record/record_error.h"
#include "console/report/table.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/say.h"
#include "idl/types/config_error.h"
#include "robot_agent/brain/learning/policy_table.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExamples = R"(Examples:
  tacit policy show policies/team                 every robot of a team
  tacit policy show policies/team/robot_3.json
  tacit policy diff before/robot_3.json after/robot_3.json
  tacit policy merge policies/team/robot_*.json --robot 1 --out merged/robot_1.json

A FILE is what `tacit run --policy DIR` keeps in DIR for each robot; docs/policy.md describes it.)";

struct PolicyWish {
  std::vector<std::string> files;
  std::string out;
  std::uint16_t robot = 1;
  bool json = false;
};

std::string read_text(const fs::path& file) {
  try {
    return read_whole_file(file);
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
}

PolicyTable read_policy(const fs::path& file) {
  return parse_policy(read_text(file), file.string());
}

/// A folder stands for the policies in it.
std::vector<fs::path> files_of(const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  for (const std::string& name : names) {
    if (!fs::is_directory(name)) {
      files.emplace_back(name);
      continue;
    }
    const std::vector<fs::path> inside = PolicyFolder(name).files();
    if (inside.empty()) {
      throw ConfigError(name + ": holds no policies, wanted robot_1.json, …");
    }
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

/// Of texts, in which numbers stand as they are to be shown.
Table table_of(TextRows rows) {
  Table table;
  for (const std::string& heading : rows.front()) {
    table.columns.push_back({heading, heading});
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::vector<TableCell> cells;
    for (std::string& text : rows[i]) {
      cells.emplace_back(std::move(text));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

void print(const Table& table, bool json) {
  std::cout << (json ? to_json(table) + '\n' : to_text(table));
}

std::string heading(const fs::path& file, const PolicyTable& policy) {
  const QTable& table = policy.table;
  return file.string() + ": robot " + std::to_string(policy.robot.value) + ", " +
         std::to_string(table.runs) + " runs, " + std::to_string(table.updates) + " updates, " +
         std::to_string(table.policy_changes) + " changes of a best role\n";
}

Exit show_all(const PolicyWish& wish) {
  for (const fs::path& file : files_of(wish.files)) {
    const PolicyTable policy = read_policy(file);
    if (!wish.json) {
      std::cout << heading(file, policy);
    }
    print(table_of(show(policy)), wish.json);
    std::cout << (wish.json ? "" : "\n");
  }
  return Exit::Done;
}

Exit diff_two(const PolicyWish& wish) {
  const TextRows rows = diff(read_policy(wish.files[0]), read_policy(wish.files[1]));
  if (rows.size() == 1 && !wish.json) {
    std::cout << "The two agree in every state.\n";
  } else {
    print(table_of(rows), wish.json);
  }
  return Exit::Done;
}

Exit merge_all(const PolicyWish& wish) {
  std::vector<PolicyTable> policies;
  for (const fs::path& file : files_of(wish.files)) {
    policies.push_back(read_policy(file));
  }
  const std::string text = to_text(merge(policies, RobotId{wish.robot}));
  if (wish.out.empty()) {
    std::cout << text;
    return Exit::Done;
  }
  if (fs::exists(wish.out)) {
    throw ConfigError("--out: " + wish.out + " is there already, wanted a new file");
  }
  write_whole_file(wish.out, text);
  say("merged " + std::to_string(policies.size()) + " policies into " + wish.out);
  return Exit::Done;
}

using Work = Exit (*)(const PolicyWish&);

/// `files` as for CLI11's `expected`: how many; below 0: at least so many.
CLI::App* add(CLI::App& policy, Exit& ending, const std::shared_ptr<PolicyWish>& wish,
              const std::pair<const char*, const char*>& name_and_doc, int files, Work work) {
  CLI::App* command = policy.add_subcommand(name_and_doc.first, name_and_doc.second);
  command->add_option("files", wish->files, "Policies, or folders of them")
      ->required()
      ->expected(files)
      ->type_name("FILE");
  command->callback([wish, work, &ending] { ending = work(*wish); });
  return command;
}

}  // namespace

void add_policy(CLI::App& app, Exit& ending) {
  CLI::App* policy = app.add_subcommand("policy", "Look at what robots have learned");
  policy->require_subcommand(1);
  policy->footer(kExamples);
  const auto wish = std::make_shared<PolicyWish>();
  CLI::App* show_command =
      add(*policy, ending, wish,
          {"show", "Print policies: state in words, values, visits, best role"}, -1, show_all);
  show_command->add_flag("--json", wish->json, "As JSON");
  CLI::App* diff_command =
      add(*policy, ending, wish, {"diff", "Print the states in which two policies differ"}, 2,
          diff_two);
  diff_command->add_flag("--json", wish->json, "As JSON");
  CLI::App* merge_command =
      add(*policy, ending, wish,
          {"merge", "Make one policy out of several, values weighted by visits"}, -1, merge_all);
  merge_command->add_option("--out", wish->out, "File to make; else it is printed");
  merge_command->add_option("--robot", wish->robot, "Robot that it is for")
      ->check(CLI::Range(1, 65535))
      ->capture_default_str();
}

}  // namespace tacit
