#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "console/gateway/server.h"
#include "console/live/replay.h"
#include "console/record/temporary_folder.h"
#include "console/server/console_server.h"
#include "console/server/job.h"
#include "console/server/library.h"
#include "console/server/live_runs.h"
#include "console/server/run_list.h"
#include "console/server/wizard_desk.h"
#include "console/server/worker.h"

namespace tacit {

/// What the handlers of the REST interface share.
struct Api {
  explicit Api(const ConsoleServerConfig& config);

  ConsoleServerConfig config;
  TemporaryFolder folder;
  const std::filesystem::path scratch;  ///< Its path.
  RunList runs;
  Library maps;
  Library missions;
  Library scenarios;
  gateway::Server server;
  std::unique_ptr<LiveRuns> live;
  std::unique_ptr<WizardDesk> wizard;
  /// Started here; a run lives on when the console goes.
  std::map<std::string, std::shared_ptr<Job>> run_jobs;
  struct Preview {
    std::shared_ptr<Job> job;
    int flights = 0;
  };
  std::map<std::string, Preview> previews;
  std::map<std::string, std::string> checklists;  ///< Of runs that are over, by id.
  /// By the run's id; those that were asked for last.
  std::vector<std::pair<std::string, std::unique_ptr<Replay>>> replays;
  std::mutex mutex;                ///< Of the four above.
  std::uint64_t numbers = 0;       ///< Given to jobs; under the mutex.
  std::unique_ptr<Worker> worker;  ///< For what takes longer than a moment.
};

/// Each adds its routes.
void add_run_routes(Api& api);
void add_library_routes(Api& api);
void add_plan_routes(Api& api);
void add_health_routes(Api& api);

/// Does `work` on `worker` and answers with what it gives; a ConfigError becomes a 422.
void answer_later(Worker& worker, const gateway::Responder& respond,
                  std::function<gateway::Response()> work);

/// The body as an object. Throws ConfigError when it is none, or has members but these.
[[nodiscard]] nlohmann::json object_of(const std::string& body,
                                       const std::vector<std::string>& members);
/// A member that is a text; empty when it is not there or null. Throws ConfigError for others.
[[nodiscard]] std::string text_member(const nlohmann::json& object, const char* name);

/// The map that is meant by `map` (its text, kept in a file) or `map_name`. Throws ConfigError.
[[nodiscard]] std::filesystem::path map_file(Api& api, const nlohmann::json& object);
/// A file of its own for `text`.
[[nodiscard]] std::filesystem::path kept(Api& api, const std::string& stem,
                                         const std::string& ending, const std::string& text);
/// A number that was not given before.
[[nodiscard]] std::uint64_t next_number(Api& api);

/// The path of `tacit`.
[[nodiscard]] std::string tacit_program(const Api& api);

}  // namespace tacit
