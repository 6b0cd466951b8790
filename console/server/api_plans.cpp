#include "console/record/files.h"
#include "console/server/api.h"
#include "idl/types/config_error.h"
#include "wizard_service/cbr/request.h"
#include "wizard_service/client/plan_json.h"

namespace tacit {
namespace {

using gateway::Method;
using gateway::Request;
using gateway::Responder;
using gateway::Response;
using nlohmann::json;

constexpr double kMostPreviewFlights = 1000;

/// What the wizard said, as an answer to a request.
Response said(const WizardClient::Reply& reply) {
  if (const auto* plans = std::get_if<PlanAnswer>(&reply)) return gateway::json(to_json(*plans));
  if (const auto* done = std::get_if<WizardDone>(&reply)) {
    return gateway::json(json{{"text", done->text}, {"cases", done->cases}}.dump());
  }
  return gateway::error(422, std::get<WizardRefusal>(reply).text);
}

/// Makes a question of the body on this thread and asks it on the wizard's.
template <class Question>
void ask(Api& api, const Request& request, const Responder& respond, Question question) {
  try {
    api.wizard->ask(question(api, request.body),
                    [respond](const WizardClient::Reply& reply) { respond(said(reply)); });
  } catch (const ConfigError& error) {
    respond(gateway::error(422, error.what()));
  }
}

WizardClient::What plans_question(Api& api, const std::string& body) {
  const json object = object_of(body, {"map", "map_name", "request"});
  const auto file = map_file(api, object);
  if (file.empty()) throw ConfigError("found no map, wanted map_name or map");
  if (!object.contains("request")) throw ConfigError("found no request, wanted one");
  return AskForPlans{plan_request_from_json(object["request"].dump()), read_whole_file(file)};
}

WizardClient::What outcome_question(Api&, const std::string& body) {
  const json object = object_of(body, {"cases", "score", "failures", "map"});
  ReportOutcome report;
  const auto list = [&](const char* name) {
    const json found = object.value(name, json::array());
    if (!found.is_array() || found.size() > 1000) {
      throw ConfigError(std::string(name) + ": wanted a list of at most 1000");
    }
    return found;
  };
  for (const json& id : list("cases")) {
    if (!id.is_number_unsigned()) throw ConfigError("cases: wanted numbers of cases");
    report.cases.push_back(id.get<CaseId>());
  }
  for (const json& failure : list("failures")) {
    if (!failure.is_string()) throw ConfigError("failures: wanted texts");
    report.failures.push_back(failure.get<std::string>());
  }
  const json score = object.value("score", json());
  if (!score.is_number() || !(score >= 0.0) || !(score <= 1.0)) {
    throw ConfigError("score: found " + score.dump() + ", wanted 0 to 1");
  }
  report.score = score.get<double>();
  report.map = text_member(object, "map");
  return report;
}

WizardClient::What mission_question(Api&, const std::string& body) {
  const json object = object_of(body, {"mission", "title", "request", "features"});
  StoreMission store{text_member(object, "mission"), text_member(object, "title"), {}};
  if (object.contains("features") == object.contains("request")) {
    throw ConfigError(
        "wanted the request that the mission was planned for, or the features of its sub-missions");
  }
  store.features = object.contains("request")
                       ? cbr::features_for(plan_request_from_json(object["request"].dump()))
                       : case_features_from_json(object["features"].dump());
  return store;
}

Response begin_preview(Api& api, const std::string& body) {
  const json object = object_of(body, {"mission", "map", "map_name", "extra", "flights", "seed"});
  const std::string mission = text_member(object, "mission");
  if (mission.empty()) throw ConfigError("found no mission, wanted its text");
  const auto map = map_file(api, object);
  if (map.empty()) throw ConfigError("found no map, wanted map_name or map");
  const json flights = object.value("flights", json(20));
  if (!flights.is_number_integer() || flights < 1 || flights > kMostPreviewFlights) {
    throw ConfigError("flights: found " + flights.dump() + ", wanted 1 to 1000");
  }
  std::vector<std::string> words{tacit_program(api),
                                 "preview",
                                 kept(api, "plan", ".cdl", mission).string(),
                                 "--map",
                                 map.string(),
                                 "--flights",
                                 flights.dump(),
                                 "--json",
                                 "--quiet"};
  const std::string extra = text_member(object, "extra");
  if (!extra.empty()) words.insert(words.end(), {"--extra", api.missions.find(extra).string()});
  const std::string id = std::to_string(next_number(api));
  auto job = std::make_shared<Job>(words, api.scratch / ("preview-" + id), Job::Life::EndsWithUs);
  const std::lock_guard lock(api.mutex);
  api.previews[id] = {std::move(job), flights.get<int>()};
  Response response = gateway::json(json{{"id", id}, {"flights", flights}}.dump());
  response.status = 202;
  return response;
}

Api::Preview preview_of(Api& api, const Request& request) {
  const std::lock_guard lock(api.mutex);
  const auto at = api.previews.find(std::string(request.parameter("id")));
  return at == api.previews.end() ? Api::Preview() : at->second;
}

/// As the page draws an interval.
json interval(const json& estimate) {
  if (!estimate.is_object()) return nullptr;
  return {{"share", estimate.value("value", 0.0)},
          {"low", estimate.value("low", 0.0)},
          {"high", estimate.value("high", 0.0)}};
}

json number_of(const json& estimate) {
  return estimate.is_object() ? estimate.value("value", json()) : json();
}

/// "Enter Library, in 3 of 20 flights: No robot of the team was there."
std::string told(const json& weakness, int flown) {
  return weakness.value("name", "") + ", in " + std::to_string(weakness.value("flights", 0)) +
         " of " + std::to_string(flown) + " flights: " + weakness.value("evidence", "");
}

Response preview_state(const Api::Preview& preview) {
  Job& job = *preview.job;
  if (job.running()) {
    const json so_far{{"state", "running"},         {"flown", 0},
                      {"flights", preview.flights}, {"success", nullptr},
                      {"mean_score", nullptr},      {"median_time_s", nullptr},
                      {"failures", json::array()}};
    return gateway::json(so_far.dump());
  }
  json result = json::parse(job.out(), nullptr, false);
  // One that was told to end before it had begun.
  if (!result.is_object() && job.exit_code().value_or(0) >= 128) result = {{"cut_short", true}};
  if (!result.is_object()) return gateway::error(422, job.complaint());
  const int flown = result.value("flown", 0);
  json failures = json::array();
  for (const json& one : result.value("weaknesses", json::array())) {
    failures.push_back(told(one, flown));
  }
  const json answer{{"state", result.value("cut_short", false) ? "cancelled" : "done"},
                    {"flown", flown},
                    {"flights", preview.flights},
                    {"alike", result.value("alike", false)},
                    {"success", interval(result.value("success", json()))},
                    {"mean_score", number_of(result.value("score", json()))},
                    {"median_time_s", number_of(result.value("time_s", json()))},
                    {"failures", failures}};
  return gateway::json(answer.dump(-1, ' ', false, json::error_handler_t::replace));
}

void add_preview_routes(Api& api) {
  api.server.route(Method::Post, "/api/previews",
                   [&api](const Request& request, const Responder& respond) {
                     answer_later(*api.worker, respond,
                                  [&api, body = request.body] { return begin_preview(api, body); });
                   });
  api.server.route(Method::Get, "/api/previews/{id}", [&api](const Request& request) {
    const Api::Preview preview = preview_of(api, request);
    return preview.job ? preview_state(preview) : gateway::error(404, "there is no such preview");
  });
  api.server.route(Method::Delete, "/api/previews/{id}", [&api](const Request& request) {
    const std::shared_ptr<Job> job = preview_of(api, request).job;
    if (!job) return gateway::error(404, "there is no such preview");
    job->interrupt();
    return gateway::json(R"({"text":"The preview was told to end."})");
  });
}

}  // namespace

void add_plan_routes(Api& api) {
  const auto question = [&api](const char* path, auto make) {
    api.server.route(Method::Post, path,
                     [&api, make](const Request& request, const Responder& respond) {
                       ask(api, request, respond, make);
                     });
  };
  question("/api/plans", plans_question);
  question("/api/outcomes", outcome_question);
  question("/api/cases", mission_question);
  add_preview_routes(api);
}

}  // namespace tacit
