#include "console/live/operator_services.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

using nlohmann::json;

/// A number that a service takes.
struct Argument {
  const char* name;
  double low;
  double high;
  bool whole;
  std::optional<double> usual;  ///< None: it must be given.
};

struct OperatorService {
  const char* name;
  ControlKind kind;
  std::vector<Argument> arguments;
};

const std::vector<OperatorService>& services() {
  static const Argument kRobot{"robot", 0, 65535, true, 0.0};
  static const Argument kX{"x", -1, 1, false, {}};
  static const Argument kY{"y", -1, 1, false, {}};
  static const std::vector<OperatorService> kServices{
      {"pause", ControlKind::Pause, {}},
      {"resume", ControlKind::Resume, {}},
      {"step", ControlKind::Step, {{"ticks", 1, 1e6, true, 1.0}}},
      {"speed", ControlKind::Speed, {{"factor", 0, 1e6, false, {}}}},
      {"stop", ControlKind::Stop, {}},
      {"proceed", ControlKind::Proceed, {kRobot}},
      {"skip_goal", ControlKind::SkipGoal, {kRobot}},
      {"steer", ControlKind::Steer, {kRobot, kX, kY}},
      {"let_go", ControlKind::LetGo, {kRobot}},
  };
  return kServices;
}

double value_of(const OperatorService& service, const Argument& argument, const json& request) {
  const std::string wanted = std::string(", wanted ") +
                             (argument.whole ? "a whole number" : "a number") + " from " +
                             json(argument.low).dump() + " to " + json(argument.high).dump();
  const auto at = request.find(argument.name);
  if (at == request.end()) {
    if (argument.usual) return *argument.usual;
    throw ConfigError(std::string(service.name) + ": found no " + argument.name + wanted);
  }
  const double value = at->is_number() ? at->get<double>() : std::nan("");
  const bool whole = !argument.whole || std::floor(value) == value;
  if (!(value >= argument.low && value <= argument.high) || !whole) {
    throw ConfigError(std::string(service.name) + ": " + argument.name + ": found " + at->dump() +
                      wanted);
  }
  return value;
}

void set(Control& control, const std::string& argument, double value) {
  if (argument == "ticks") {
    control.ticks = static_cast<std::uint32_t>(value);
  } else if (argument == "factor") {
    control.speed = value;
  } else if (argument == "robot") {
    control.robot = {static_cast<std::uint16_t>(value)};
  } else if (argument == "x") {
    control.joystick = {value, control.joystick.y()};
  } else {
    control.joystick = {control.joystick.x(), value};
  }
}

std::string request_schema(const OperatorService& service) {
  json properties = json::object();
  json required = json::array();
  for (const Argument& argument : service.arguments) {
    properties[argument.name] = {{"type", argument.whole ? "integer" : "number"},
                                 {"minimum", argument.low},
                                 {"maximum", argument.high}};
    if (!argument.usual) required.push_back(argument.name);
  }
  return json{{"type", "object"}, {"properties", properties}, {"required", required}}.dump();
}

}  // namespace

Control control_of(std::string_view name, std::string_view request_json) {
  for (const OperatorService& service : services()) {
    if (service.name != name) continue;
    const json request = json::parse(request_json, nullptr, false);
    if (!request.is_object()) {
      throw ConfigError(std::string(name) + ": found no JSON object, wanted one");
    }
    Control control;
    control.kind = service.kind;
    for (const Argument& argument : service.arguments) {
      set(control, argument.name, value_of(service, argument, request));
    }
    control.joystick = clipped(control.joystick, 1.0);
    return control;
  }
  throw ConfigError("there is no service " + std::string(name));
}

void add_operator_services(gateway::Session& session, std::function<void(const Control&)> say) {
  for (const OperatorService& service : services()) {
    session.add_service({service.name, std::string("tacit/") + service.name,
                         request_schema(service), R"({"type":"object"})"},
                        [say, name = std::string(service.name)](
                            std::string_view request, const gateway::ServiceReply& reply) {
                          try {
                            say(control_of(name, request));
                            reply.ok("{}");
                          } catch (const ConfigError& error) {
                            reply.fail(error.what());
                          }
                        });
  }
}

}  // namespace tacit
