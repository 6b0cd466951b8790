#include <algorithm>

#include "console/mcap/mcap_error.h"
#include "console/record/run.h"
#include "console/server/api.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using gateway::Method;
using gateway::Request;
using gateway::Responder;
using gateway::Response;
using nlohmann::json;

/// For a run to have begun, or to have said why it cannot.
constexpr std::chrono::seconds kBegin{20};
constexpr std::chrono::milliseconds kLook{20};
/// Recordings that are played at once; one more, and the one that was asked for first goes.
constexpr std::size_t kMostReplays = 8;

/// A member that is a number, or a text that `tacit run` takes in its place, as it is to be typed.
std::string typed(const json& object, const char* name) {
  const auto at = object.find(name);
  if (at == object.end() || at->is_null()) return {};
  if (at->is_string()) return at->get<std::string>();
  if (at->is_number()) return at->dump();
  throw ConfigError(std::string(name) + ": found " + at->dump().substr(0, 100) +
                    ", wanted a number or a text");
}

/// What is to be run: a scenario's name or file, or a mission's file.
std::string subject(Api& api, const json& object) {
  const std::string scenario = text_member(object, "scenario");
  const std::string mission = text_member(object, "mission");
  const std::string mission_name = text_member(object, "mission_name");
  const int given =
      (scenario.empty() ? 0 : 1) + (mission.empty() ? 0 : 1) + (mission_name.empty() ? 0 : 1);
  if (given != 1) {
    throw ConfigError("found " + std::to_string(given) +
                      " of scenario, mission and mission_name, wanted one");
  }
  if (!scenario.empty()) return api.scenarios.find(scenario).string();
  if (!mission.empty()) return kept(api, "plan", ".cdl", mission).string();
  return api.missions.find(mission_name).string();
}

std::string compact_now() {
  std::string now = utc_now();
  std::erase_if(now, [](char c) { return c == '-' || c == ':'; });
  return now.substr(0, now.find('.'));
}

std::string new_id(Api& api, const fs::path& subject, const std::string& seed) {
  std::string id = subject.stem().string() + '-' + (seed.empty() ? "1" : seed) + '-' +
                   compact_now() + '-' + std::to_string(next_number(api));
  std::replace_if(
      id.begin(), id.end(), [](char c) { return !RunList::is_id(std::string(1, c)) && c != '.'; },
      '_');
  return id;
}

Response begin_run(Api& api, const std::string& body) {
  const json object =
      object_of(body, {"scenario", "mission", "mission_name", "map_name", "map", "robots",
                       "learner", "strategy", "seed", "speed", "extra", "duration", "title"});
  const fs::path what = subject(api, object);
  const fs::path map = map_file(api, object);
  const std::string seed = typed(object, "seed");
  const std::string id = new_id(api, what, seed);
  std::vector<std::string> words{tacit_program(api),
                                 "run",
                                 what.string(),
                                 "--quiet",
                                 "--record",
                                 "--out",
                                 (api.runs.folder() / id).string()};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--map", map.string());
  const std::string speed = typed(object, "speed");
  add("--speed", speed == "0" ? "max" : speed);
  for (const char* name : {"robots", "learner", "strategy", "duration"}) {
    add((std::string("--") + name).c_str(), typed(object, name));
  }
  add("--seed", seed);
  const std::string extra = text_member(object, "extra");
  if (!extra.empty()) add("--extra", api.missions.find(extra).string());
  auto job = std::make_shared<Job>(words, api.scratch / ("run-" + id), Job::Life::LivesOn);
  const auto until = std::chrono::steady_clock::now() + kBegin;
  while (!fs::exists(api.runs.folder() / id / "run.json")) {
    if (job->wait(kLook) || std::chrono::steady_clock::now() >= until) {
      if (job->exit_code().value_or(0) == 0) break;
      throw ConfigError(job->complaint());
    }
  }
  const std::lock_guard lock(api.mutex);
  api.run_jobs[id] = std::move(job);
  Response response = gateway::json(json{{"id", id}}.dump());
  response.status = 201;
  return response;
}

/// Of a run that is over it is worked out once.
std::string checklist_of(Api& api, const std::string& id) {
  {
    const std::lock_guard lock(api.mutex);
    const auto known = api.checklists.find(id);
    if (known != api.checklists.end()) return known->second;
  }
  const bool over = api.runs.is_over(id);
  Job job({tacit_program(api), "debrief", (api.runs.folder() / id).string(), "--json"},
          api.scratch / ("debrief-" + std::to_string(next_number(api))), Job::Life::EndsWithUs);
  job.wait(kBegin);
  const std::string list = job.exit_code() == 0 ? job.out() : std::string("null");
  if (over) {
    const std::lock_guard lock(api.mutex);
    api.checklists[id] = list;
  }
  return list;
}

Response end_run(Api& api, const std::string& id) {
  (void)api.runs.open(id);
  std::shared_ptr<Job> job;
  {
    const std::lock_guard lock(api.mutex);
    const auto at = api.run_jobs.find(id);
    if (at != api.run_jobs.end()) job = at->second;
  }
  Control stop;
  stop.kind = ControlKind::Stop;
  if (job && job->running()) {
    job->interrupt();
  } else if (!api.live->say(id, stop)) {
    return gateway::error(409, "the run " + id + " is not going on");
  }
  return gateway::json(R"({"text":"The run was told to end."})");
}

std::string replay_id(const std::string& run) { return "replay-" + run; }

void close_replay(Api& api, const std::string& run) {
  std::unique_ptr<Replay> closed;
  {
    const std::lock_guard lock(api.mutex);
    const auto at = std::find_if(api.replays.begin(), api.replays.end(),
                                 [&](const auto& one) { return one.first == run; });
    if (at == api.replays.end()) return;
    closed = std::move(at->second);
    api.replays.erase(at);
  }
  closed.reset();
  api.server.close_session(replay_id(run));
}

Response begin_replay(Api& api, const std::string& body) {
  const std::string run = text_member(object_of(body, {"run"}), "run");
  const fs::path file = api.runs.open(run).path() / "run.mcap";
  if (!fs::exists(file)) {
    throw ConfigError("the run " + run + " has no recording, wanted one made with --record");
  }
  close_replay(api, run);
  std::string oldest;
  {
    const std::lock_guard lock(api.mutex);
    if (api.replays.size() >= kMostReplays) oldest = api.replays.front().first;
  }
  if (!oldest.empty()) close_replay(api, oldest);
  const std::string id = replay_id(run);
  try {
    auto replay =
        std::make_unique<Replay>(api.server.open_session(id, "Tacit replay of " + run), file);
    const std::lock_guard lock(api.mutex);
    api.replays.emplace_back(run, std::move(replay));
  } catch (const McapError& error) {
    api.server.close_session(id);
    throw ConfigError(error.what());
  }
  Response response = gateway::json(json{{"id", id}}.dump());
  response.status = 201;
  return response;
}

}  // namespace

void add_run_routes(Api& api) {
  const auto later = [&api](Method method, const char* pattern, auto work) {
    api.server.route(
        method, pattern, [&api, work](const Request& request, const Responder& respond) {
          answer_later(*api.worker, respond, [&api, work, request] { return work(api, request); });
        });
  };
  later(Method::Get, "/api/runs",
        [](Api& a, const Request&) { return gateway::json(a.runs.to_json()); });
  later(Method::Get, "/api/runs/{id}", [](Api& a, const Request& request) {
    const std::string id(request.parameter("id"));
    if (!RunList::is_id(id) || !fs::exists(a.runs.folder() / id)) {
      return gateway::error(404, "there is no run " + id);
    }
    return gateway::json(a.runs.to_json(id, checklist_of(a, id)));
  });
  later(Method::Post, "/api/runs",
        [](Api& a, const Request& request) { return begin_run(a, request.body); });
  later(Method::Delete, "/api/runs/{id}", [](Api& a, const Request& request) {
    return end_run(a, std::string(request.parameter("id")));
  });
  later(Method::Post, "/api/replays",
        [](Api& a, const Request& request) { return begin_replay(a, request.body); });
  later(Method::Delete, "/api/replays/{run}", [](Api& a, const Request& request) {
    close_replay(a, std::string(request.parameter("run")));
    return gateway::json(R"({"text":"Closed."})");
  });
}

}  // namespace tacit
