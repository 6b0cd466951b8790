#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tacit::gateway {

class SessionState;

/// Bytes that all clients share.
using Payload = std::shared_ptr<const std::vector<std::uint8_t>>;
using ChannelId = std::uint32_t;
using ServiceId = std::uint32_t;

/// What a channel's messages are worth when they are no longer new.
enum class Keep {
  Latest,  ///< States: who subscribes late gets the latest at once, who reads slowly gets fewer.
  All,     ///< Happenings: who reads slowly gets all, up to Limits::queue_all.
};

struct Channel {
  std::string topic = {};
  std::string encoding = {};  ///< Of messages, such as "cdr" or "json".
  std::string schema_name = {};
  std::string schema = {};  ///< Text.
  std::string schema_encoding =
      {};  ///< Such as "ros2msg" or "jsonschema"; "" leaves it to the client.
  Keep keep = Keep::All;
};

/// A service that takes and gives JSON.
struct Service {
  std::string name = {};
  std::string type = {};             ///< A name for the pair of schemas.
  std::string request_schema = {};   ///< JSON Schema as text; an object.
  std::string response_schema = {};  ///< The same.
};

/// Answers one call, from any thread, once; further answers are ignored. When the last copy goes
/// without an answer, the call fails. May outlive session and server, and then does nothing.
class ServiceReply {
 public:
  using Send = std::function<void(bool ok, std::string_view text)>;
  explicit ServiceReply(Send send);
  void ok(std::string_view json) const;
  void fail(std::string_view message) const;

 private:
  class Once;
  std::shared_ptr<Once> once_;
};

/// `request` is a JSON text that parses; "{}" when the client sent nothing. Runs on the server's
/// thread, so it returns within milliseconds and may answer later. What it throws fails the call.
using ServiceHandler = std::function<void(std::string_view request, ServiceReply reply)>;

struct Parameter {
  std::string name = {};
  std::string value = {};  ///< JSON text.
  std::string type = {};  ///< "", or "float64", "float64_array" or "byte_array" as in the protocol.
};

/// A client wants these values. Runs on the server's thread. It makes them count by
/// Session::set_parameters, now or later; the client is then told what holds.
using ParameterHandler = std::function<void(const std::vector<Parameter>& wanted)>;

enum class StatusLevel { Info = 0, Warning = 1, Error = 2 };

/// Who sends and takes which topic, and who offers which service: names to ids of the parties.
struct ConnectionGraph {
  using Ends = std::map<std::string, std::set<std::string>>;
  Ends publishers = {};
  Ends subscribers = {};
  Ends providers = {};
};

/// What clients of one socket see: a run, say. Comes from Server::open_session.
///
/// All functions may be called from any thread, also from handlers. None waits for a client, and
/// none throws on account of one. After the session was closed they do nothing.
class Session {
 public:
  explicit Session(std::shared_ptr<SessionState> state);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] const std::string& id() const;

  /// Tells all clients, present and to come. Ids are not used again in a session.
  ChannelId advertise(const Channel& channel);
  void unadvertise(ChannelId channel);

  /// Sends to those who subscribe to the channel; an unknown channel is ignored. `log_time_ns` is
  /// of the clock that `set_time` tells.
  void publish(ChannelId channel, std::uint64_t log_time_ns, Payload bytes);
  /// The same, and copies the bytes once if anybody wants them.
  void publish(ChannelId channel, std::uint64_t log_time_ns, std::span<const std::uint8_t> bytes);
  /// How many clients subscribe to it.
  [[nodiscard]] std::size_t subscribers(ChannelId channel) const;
  /// How many clients there are.
  [[nodiscard]] std::size_t clients() const;

  /// The time of the session's clock. A client that reads slowly gets the latest only.
  void set_time(std::uint64_t time_ns);

  ServiceId add_service(const Service& service, ServiceHandler handler);
  void remove_service(ServiceId service);

  /// Adds or replaces parameters and tells those who follow them. A value that is no JSON is an
  /// error of the caller: std::invalid_argument.
  void set_parameters(const std::vector<Parameter>& parameters);
  /// Without a handler, what clients set is refused with a status message.
  void on_parameters(ParameterHandler handler);

  /// Clients that follow the graph get what changed.
  void set_connection_graph(const ConnectionGraph& graph);

  /// A line for the clients' problem lists. With an id it stays, for clients to come as well,
  /// until it is replaced or removed; without, only those who are there get it.
  void status(StatusLevel level, std::string_view message, std::string_view id = {});
  void remove_status(std::string_view id);

 private:
  std::shared_ptr<SessionState> state_;
};

}  // namespace tacit::gateway
