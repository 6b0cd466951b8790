#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "console/record/trajectory_file.h"
#include "console/tape/tape_reader.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/replay_info.h"
#include "deploy/tacit/say.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExamples = R"(Examples:
  tacit replay runs/guard-7-20300131T235959Z/run.mcap
  tacit replay run.mcap --events > events.jsonl
  tacit replay run.mcap --csv > poses.csv
  tacit replay run.mcap --info --json

`tacit run --record` makes such files; docs/recording.md says what is in them and what else opens
them. One that was cut off is read as far as it goes.

Exit codes: 0 told, 2 no recording of Tacit's, or a damaged one.)";

struct ReplayWish {
  std::string file;
  bool info = false;
  bool events = false;
  bool csv = false;
  bool json = false;
};

/// A run directory stands for the recording in it.
fs::path file_of(const std::string& name) {
  return fs::is_directory(name) ? fs::path(name) / "run.mcap" : fs::path(name);
}

void tell_trouble(const TapeReader& tape) {
  if (!tape.mcap().trouble().empty()) say("the file is not whole: " + tape.mcap().trouble());
}

void print_events(const TapeReader& tape) {
  tell_trouble(tape);
  tape.events([](const Event& event) { std::cout << to_line(event) << '\n'; });
}

void print_poses(const TapeReader& tape) {
  tell_trouble(tape);
  std::cout << kTrajectoryColumns;
  std::string lines;
  tape.views([&](const WorldView& view) {
    lines.clear();
    append_trajectory_lines(lines, view);
    std::cout << lines;
  });
}

void print_info(const TapeReader& tape, bool as_json) {
  const ReplayInfo info = info_of(tape);
  std::cout << (as_json ? info_json(info) + '\n' : info_text(info));
}

Exit replay(const ReplayWish& wish) {
  if (wish.json && (wish.events || wish.csv)) {
    throw ConfigError("--json: goes with --info, found --events or --csv");
  }
  try {
    const TapeReader tape(file_of(wish.file));
    if (wish.events) {
      print_events(tape);
    } else if (wish.csv) {
      print_poses(tape);
    } else {
      print_info(tape, wish.json);
    }
  } catch (const McapError& error) {
    throw ConfigError(error.what());
  }
  std::cout << std::flush;
  return Exit::Done;
}

}  // namespace

void add_replay(CLI::App& app, Exit& ending) {
  CLI::App* command = app.add_subcommand("replay", "Tell what a recording (.mcap) holds");
  const auto wish = std::make_shared<ReplayWish>();
  command->add_option("file", wish->file, "Recording, or a run directory with run.mcap")
      ->required();
  CLI::Option_group* what = command->add_option_group("what", "What to print");
  what->add_flag("--info", wish->info, "A summary; also when nothing is asked for");
  what->add_flag("--events", wish->events, "The event log, line by line");
  what->add_flag("--csv", wish->csv, "Where bodies were, as CSV");
  what->require_option(0, 1);
  command->add_flag("--json", wish->json, "The summary as one JSON object");
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = replay(*wish); });
}

}  // namespace tacit
