#include "console/server/api.h"

#include <algorithm>
#include <stdexcept>

#include "console/record/files.h"
#include "console/record/record_error.h"
#include "idl/types/config_error.h"
#include "idl/types/nearest_word.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

gateway::ServerConfig gateway_config(const ConsoleServerConfig& config) {
  gateway::ServerConfig gateway;
  gateway.address = config.address;
  gateway.port = config.port;
  gateway.pages = config.pages;
  gateway.name = "Tacit";
  gateway.token = config.token;
  gateway.origins = config.origins;
  return gateway;
}

}  // namespace

Api::Api(const ConsoleServerConfig& given)
    : config(given),
      folder("tacit-console"),
      scratch(folder.path()),
      runs(given.runs),
      maps(given.maps, ".ovl"),
      missions(given.missions, ".cdl"),
      scenarios(given.scenarios, ".toml"),
      server(gateway_config(given)) {}

void answer_later(Worker& worker, const gateway::Responder& respond,
                  std::function<gateway::Response()> work) {
  worker.put([respond, work = std::move(work)] {
    try {
      respond(work());
    } catch (const ConfigError& error) {
      respond(gateway::error(422, error.what()));
    } catch (const std::exception& error) {
      respond(gateway::error(500, error.what()));
    }
  });
}

nlohmann::json object_of(const std::string& body, const std::vector<std::string>& members) {
  nlohmann::json object = nlohmann::json::parse(body, nullptr, false);
  if (!object.is_object()) throw ConfigError("found no JSON object, wanted one");
  for (const auto& [name, value] : object.items()) {
    if (std::find(members.begin(), members.end(), name) != members.end()) continue;
    throw ConfigError("there is no member \"" + name + '"' + did_you_mean(name, members));
  }
  return object;
}

std::string text_member(const nlohmann::json& object, const char* name) {
  const auto at = object.find(name);
  if (at == object.end() || at->is_null()) return {};
  if (!at->is_string()) {
    throw ConfigError(std::string(name) + ": found " + at->dump().substr(0, 100) +
                      ", wanted a text");
  }
  return at->get<std::string>();
}

fs::path map_file(Api& api, const nlohmann::json& object) {
  const std::string text = text_member(object, "map");
  const std::string name = text_member(object, "map_name");
  if (!text.empty() && !name.empty()) {
    throw ConfigError("found map and map_name, wanted one of them");
  }
  if (!text.empty()) return kept(api, "map", ".ovl", text);
  return name.empty() ? fs::path() : api.maps.find(name);
}

fs::path kept(Api& api, const std::string& stem, const std::string& ending,
              const std::string& text) {
  const fs::path folder = api.scratch / std::to_string(next_number(api));
  fs::create_directories(folder);
  const fs::path file = folder / (stem + ending);
  try {
    write_whole_file(file, text);
  } catch (const RecordError& error) {
    throw std::runtime_error(error.what());
  }
  return file;
}

std::uint64_t next_number(Api& api) {
  const std::lock_guard lock(api.mutex);
  return ++api.numbers;
}

std::string tacit_program(const Api& api) { return (api.config.programs / "tacit").string(); }

}  // namespace tacit
