#include "console/gateway/client_words.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <string>

namespace tacit::gateway {
namespace {

using messages::Json;

/// JSON of strangers nests no deeper than any message of the protocol needs: what reads and writes
/// it is recursive.
constexpr int kDeepest = 32;

bool is_shallow(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      i += c == '\\' ? 1 : 0;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepest) {
        return false;
      }
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return true;
}

void complain(SessionState& session, const ClientPtr& client, std::string_view what) {
  session.tell(client, messages::status(StatusLevel::Error, what, {}));
}

std::optional<std::uint32_t> number(const Json& json) {
  if (!json.is_number_unsigned()) {
    return std::nullopt;
  }
  const auto value = json.get<std::uint64_t>();
  return value <= std::numeric_limits<std::uint32_t>::max()
             ? std::optional(static_cast<std::uint32_t>(value))
             : std::nullopt;
}

/// A member, or null.
const Json& member(const Json& object, const char* name) {
  static const Json kNone;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() ? *found : kNone;
}

std::optional<std::set<std::string>> names(const Json& json) {
  const Json& list = member(json, "parameterNames");
  if (!list.is_array()) {
    return std::nullopt;
  }
  std::set<std::string> names;
  for (const Json& name : list) {
    if (!name.is_string()) {
      return std::nullopt;
    }
    names.insert(name.get<std::string>());
  }
  return names;
}

std::optional<std::vector<Parameter>> parameters(const Json& json) {
  const Json& list = member(json, "parameters");
  if (!list.is_array() || list.empty()) {
    return std::nullopt;
  }
  std::vector<Parameter> parameters;
  for (const Json& one : list) {
    const Json& name = member(one, "name");
    const Json& type = member(one, "type");
    if (!name.is_string() || !(type.is_string() || type.is_null())) {
      return std::nullopt;
    }
    parameters.push_back({name.get<std::string>(),
                          member(one, "value").dump(-1, ' ', false, Json::error_handler_t::replace),
                          type.is_string() ? type.get<std::string>() : ""});
  }
  return parameters;
}

/// One client that says one thing.
class Hearing {
 public:
  Hearing(SessionState& session, const ClientPtr& client) : session_(session), client_(client) {}

  void hear(const Json& json) {
    const Json& op = member(json, "op");
    const std::string word = op.is_string() ? op.get<std::string>() : "";
    if (word == "subscribe") {
      subscribe(member(json, "subscriptions"));
    } else if (word == "unsubscribe") {
      unsubscribe(member(json, "subscriptionIds"));
    } else if (word == "setParameters") {
      set_parameters(json);
    } else if (word == "subscribeConnectionGraph" || word == "unsubscribeConnectionGraph") {
      session_.follow_graph(client_, word.front() == 's');
    } else if (word.ends_with("Parameters") || word.ends_with("ParameterUpdates")) {
      about_parameters(word, json);
    } else {
      refuse("not understood here: op " + op.dump(-1, ' ', false, Json::error_handler_t::replace));
    }
  }

 private:
  void refuse(const std::string& reason) {
    if (!reason.empty()) {
      complain(session_, client_, reason);
    }
  }

  void subscribe(const Json& list) {
    if (!list.is_array()) {
      return refuse("subscribe: no list of subscriptions");
    }
    for (const Json& one : list) {
      const auto id = number(member(one, "id"));
      const auto channel = number(member(one, "channelId"));
      refuse(id && channel ? session_.subscribe(client_, *id, *channel)
                           : "subscribe: a subscription has an id and a channelId");
    }
  }

  void unsubscribe(const Json& list) {
    if (!list.is_array()) {
      return refuse("unsubscribe: no list of subscriptionIds");
    }
    for (const Json& one : list) {
      const auto id = number(one);
      refuse(id ? session_.unsubscribe(client_, *id) : "unsubscribe: an id is a number");
    }
  }

  void set_parameters(const Json& json) {
    const auto wanted = parameters(json);
    if (!wanted) {
      return refuse("setParameters: no list of parameters with names and values");
    }
    refuse(session_.wish_parameters(*wanted));
    if (const Json& question = member(json, "id"); !question.is_null()) {
      std::set<std::string> asked;
      for (const Parameter& parameter : *wanted) {
        asked.insert(parameter.name);
      }
      session_.give_parameters(client_, asked, question);
    }
  }

  void about_parameters(const std::string& word, const Json& json) {
    const auto asked = names(json);
    if (!asked) {
      return refuse(word + ": no list of parameterNames");
    }
    if (word == "getParameters") {
      session_.give_parameters(client_, *asked, member(json, "id"));
    } else if (word == "subscribeParameterUpdates") {
      session_.follow_parameters(client_, *asked);
    } else if (word == "unsubscribeParameterUpdates") {
      session_.unfollow_parameters(client_, *asked);
    } else {
      refuse("not understood here: op " + word);
    }
  }

  SessionState& session_;
  const ClientPtr& client_;
};

/// Takes a number from the front.
std::optional<std::uint32_t> take(std::span<const std::uint8_t>& bytes) {
  std::uint32_t number = 0;
  if (bytes.size() < sizeof number) {
    return std::nullopt;
  }
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes = bytes.subspan(sizeof number);
  return number;
}

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

void hear_text(SessionState& session, const ClientPtr& client, std::string_view text) {
  if (!is_shallow(text)) {
    return complain(session, client, "the message nests too deep");
  }
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    return complain(session, client, "the message is no JSON object");
  }
  Hearing(session, client).hear(json);
}

void hear_binary(SessionState& session, const ClientPtr& client,
                 std::span<const std::uint8_t> bytes) {
  constexpr std::uint8_t kServiceCall = 2;
  if (bytes.empty() || bytes.front() != kServiceCall) {
    return complain(session, client, "not understood here: a binary message of this kind");
  }
  bytes = bytes.subspan(1);
  const auto service = take(bytes);
  const auto call = take(bytes);
  const auto length = take(bytes);
  if (!service || !call || !length || *length > bytes.size()) {
    return complain(session, client, "a service call is cut short");
  }
  const std::string_view encoding = text_of(bytes.first(*length));
  std::string_view request = text_of(bytes.subspan(*length));
  request = request.empty() ? "{}" : request;
  if (encoding != "json" || !is_shallow(request) || !Json::accept(request)) {
    return session.tell(client,
                        messages::service_failure(*service, *call, "the request is no JSON"));
  }
  session.call(client, *service, *call, request);
}

}  // namespace tacit::gateway
