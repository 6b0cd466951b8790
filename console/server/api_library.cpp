#include "console/record/files.h"
#include "console/server/api.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

using gateway::Method;
using gateway::Request;
using gateway::Responder;
using gateway::Response;
using Json = nlohmann::ordered_json;

/// The value of `key = "..."` at a line's begin of a scenario; empty when there is none.
std::string text_of_key(const std::string& toml, const std::string& key) {
  const std::string begin = "\n" + key + " = \"";
  const std::size_t at = ("\n" + toml).find(begin);
  if (at == std::string::npos) return {};
  const std::size_t from = at + begin.size() - 1;
  return toml.substr(from, toml.find('"', from) - from);
}

/// What a mission's first comment says, in one line.
std::string title_of(const std::string& mission) {
  const std::size_t from = mission.find("/*");
  const std::size_t to = mission.find("*/");
  if (from != 0 || to == std::string::npos) return {};
  std::string title;
  for (const char c : mission.substr(from + 2, std::min<std::size_t>(to - from - 2, 400))) {
    const bool blank = c == '\n' || c == ' ' || c == '*' || c == '\t' || c == '\r';
    if (!blank) {
      title += c;
    } else if (!title.empty() && title.back() != ' ') {
      title += ' ';
    }
  }
  return title.substr(0,
                      title.find(". ") == std::string::npos ? title.size() : title.find(". ") + 1);
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Response scene(Api& api, const std::vector<std::string>& words) {
  std::vector<std::string> all{tacit_program(api), "scene"};
  all.insert(all.end(), words.begin(), words.end());
  Job job(all, api.scratch / ("scene-" + std::to_string(next_number(api))), Job::Life::EndsWithUs);
  job.wait(std::chrono::seconds(20));
  if (job.exit_code() != 0) throw ConfigError(job.complaint());
  return gateway::json(job.out());
}

}  // namespace

void add_library_routes(Api& api) {
  api.server.route(Method::Get, "/api/maps", [&api](const Request&) {
    Json list = Json::array();
    for (const auto& file : api.maps.files()) list.push_back({{"name", file.stem().string()}});
    return gateway::json(dumped(list));
  });
  api.server.route(Method::Get, "/api/missions", [&api](const Request&) {
    Json list = Json::array();
    for (const auto& file : api.missions.files()) {
      list.push_back({{"name", file.stem().string()}, {"title", title_of(read_whole_file(file))}});
    }
    return gateway::json(dumped(list));
  });
  api.server.route(Method::Get, "/api/missions/{name}", [&api](const Request& request) {
    try {
      const auto file = api.missions.find(std::string(request.parameter("name")));
      return Response{200, "text/plain; charset=utf-8", read_whole_file(file), {}, {}};
    } catch (const ConfigError& error) {
      return gateway::error(404, error.what());
    }
  });
  api.server.route(Method::Get, "/api/scenarios", [&api](const Request&) {
    Json list = Json::array();
    for (const auto& file : api.scenarios.files()) {
      list.push_back({{"name", file.stem().string()},
                      {"description", text_of_key(read_whole_file(file), "description")}});
    }
    return gateway::json(dumped(list));
  });
  api.server.route(
      Method::Get, "/api/maps/{name}", [&api](const Request& request, const Responder& respond) {
        answer_later(*api.worker, respond, [&api, name = std::string(request.parameter("name"))] {
          return scene(api, {"--map", api.maps.find(name).string()});
        });
      });
  api.server.route(Method::Get, "/api/runs/{id}/scene",
                   [&api](const Request& request, const Responder& respond) {
                     answer_later(*api.worker, respond,
                                  [&api, id = std::string(request.parameter("id"))] {
                                    return scene(api, {api.runs.open(id).path().string()});
                                  });
                   });
}

}  // namespace tacit
