#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "console/record/run_directory.h"
#include "deploy/lockstep/setup.h"
#include "idl/scenario/scenario_file.h"

namespace tacit {

/// What a person asked for. Empty texts were not given.
struct RunWish {
  std::string scenario = "guard";  ///< Name or file.
  std::string robots;
  std::string learner;
  std::string strategy;
  std::string seed;
  std::string map;
  std::string extra;  ///< Mission of robots beside the team.
  std::string extra_colour = "red";
  std::vector<std::string> starts;        ///< "x,y,heading", of the team's first robots.
  std::vector<std::string> extra_starts;  ///< In the same way of the extras.
  std::string duration_s;
  std::vector<std::string> settings;  ///< "section.key=value"
  std::string out;
  std::string store;
  std::string policy;  ///< Folder from which policies come and where they go.
  std::vector<std::string> command_line;
  bool record = false;      ///< What the run tells people, as an MCAP file.
  std::string record_file;  ///< Empty for run.mcap in the run directory.
  bool one_process = false;
  bool trajectories = false;
  bool profile = false;  ///< Tell where the time went; in one process only.
  bool quiet = false;
  bool json = false;       ///< The result as one JSON object.
  double speed = 0.0;      ///< Times real time; 0 for as fast as it goes.
  double timeout_s = 0.0;  ///< Wall time; 0 for none.
  /// For an agent's command; 0 for no limit. Absent: no limit at full speed, else a second.
  std::optional<int> patience_ms;
};

/// A run that can be made: all that was asked for has been found possible.
struct RunPlan {
  RunWish wish;
  Setup setup;
  std::string scenario_toml;         ///< As resolved.
  std::vector<PolicyText> policies;  ///< To begin with; empty: with nothing learned.
  RunFacts facts;
  std::filesystem::path out;
  std::filesystem::path store;
  std::filesystem::path tape;  ///< Empty for none.
};

/// The scenario with the person's wishes over its own values. Throws ConfigError when it cannot
/// be, also when the world cannot be built from it.
[[nodiscard]] Setup resolve(const RunWish& wish);

/// Throws ConfigError. Makes nothing yet.
[[nodiscard]] RunPlan plan(RunWish wish);

/// Makes the plan's run directory with its folder for logs and the policies that the run begins
/// with, and the store if it is not there.
/// Throws ConfigError when the directory is occupied or the store is none, RecordError when one
/// cannot be written.
[[nodiscard]] RunDirectory make_directory(const RunPlan& plan);

/// Where the run keeps what is learned: the wish's folder, else one in the run directory. None when
/// the team does not learn and nobody asked.
[[nodiscard]] std::optional<PolicyFolder> learned_folder(const RunPlan& plan,
                                                         const RunDirectory& directory);

}  // namespace tacit
