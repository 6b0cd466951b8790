#include <prometheus/collectable.h>
#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>
#include <unistd.h>

#include "console/server/api.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

using gateway::Method;
using gateway::Request;
using gateway::Response;

void add_gauge(prometheus::Registry& registry, const char* name, const char* help, double value) {
  prometheus::BuildGauge().Name(name).Help(help).Register(registry).Add({}).Set(value);
}

void add_counter(prometheus::Registry& registry, const char* name, const char* help,
                 std::uint64_t value) {
  prometheus::BuildCounter().Name(name).Help(help).Register(registry).Add({}).Increment(
      static_cast<double>(value));
}

std::string metrics_text(const Api& api) {
  const gateway::Counters now = api.server.counters();
  prometheus::Registry registry;
  add_gauge(registry, "tacit_runs_live", "Runs that go on.",
            static_cast<double>(api.live->count()));
  add_gauge(registry, "tacit_connections_open", "Connections, WebSockets included.",
            static_cast<double>(now.connections_open));
  add_gauge(registry, "tacit_websockets_open", "WebSockets.",
            static_cast<double>(now.websockets_open));
  add_counter(registry, "tacit_connections_total", "Connections accepted.", now.connections_total);
  add_counter(registry, "tacit_connections_refused_total", "Connections beyond the limit.",
              now.connections_refused);
  add_counter(registry, "tacit_websockets_stalled_total",
              "WebSockets closed because their client did not read.", now.websockets_stalled);
  add_counter(registry, "tacit_messages_sent_total", "Messages sent over WebSockets.",
              now.messages_sent);
  add_counter(registry, "tacit_messages_dropped_total", "Telemetry that a client was too slow for.",
              now.messages_dropped);
  add_counter(registry, "tacit_messages_received_total", "Messages from WebSocket clients.",
              now.messages_received);
  add_counter(registry, "tacit_sent_bytes_total", "Payloads of messages sent over WebSockets.",
              now.bytes_sent);
  auto& requests = prometheus::BuildCounter()
                       .Name("tacit_http_requests_total")
                       .Help("Requests answered, by status.")
                       .Register(registry);
  for (const auto& [status, count] : now.requests_by_status) {
    requests.Add({{"status", std::to_string(status)}}).Increment(static_cast<double>(count));
  }
  return prometheus::TextSerializer().Serialize(registry.Collect());
}

/// Why a run could not be begun now; empty when it could.
std::string not_ready(const Api& api) {
  if (::access(api.runs.folder().c_str(), W_OK) != 0) {
    return api.runs.folder().string() + ": cannot be written to";
  }
  for (const char* program : {"tacit", "wizard_service", "world_server", "robot_agent"}) {
    const std::string file = (api.config.programs / program).string();
    if (::access(file.c_str(), X_OK) != 0) return file + ": is not there";
  }
  return {};
}

}  // namespace

void add_health_routes(Api& api) {
  api.server.route(Method::Get, "/metrics", [&api](const Request&) {
    return Response{200, "text/plain; version=0.0.4; charset=utf-8", metrics_text(api), {}, {}};
  });
  api.server.route(Method::Get, "/api/health",
                   [](const Request&) { return gateway::json(R"({"status":"ok"})"); });
  api.server.route(Method::Get, "/api/ready", [&api](const Request&) {
    const std::string trouble = not_ready(api);
    return trouble.empty() ? gateway::json(R"({"status":"ready"})") : gateway::error(503, trouble);
  });
  api.server.route(Method::Get, "/api/version", [](const Request&) {
    return gateway::json(
        nlohmann::json{{"name", "Tacit"}, {"version", std::string(version())}}.dump());
  });
}

}  // namespace tacit
