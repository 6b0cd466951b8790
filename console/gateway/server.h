#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "console/gateway/counters.h"
#include "console/gateway/http.h"
#include "console/gateway/limits.h"
#include "console/gateway/session.h"

namespace tacit::gateway {

/// A server that cannot begin, with the reason.
class ServerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ServerConfig {
  std::string address = "127.0.0.1";  ///< IPv4 or IPv6.
  std::uint16_t port = 0;             ///< 0: any that is free.
  std::filesystem::path pages = {};   ///< Folder of static files; a built-in page when not there.
  std::string name = "gateway";       ///< What clients are told.
  /// What a client must know: `Authorization: Bearer`, `?token=`, or the cookie that the latter
  /// leaves. When empty, none is needed on a loopback address, and one is made up elsewhere.
  std::string token = {};
  /// Names by which the server may be called beside localhost, 127.0.0.1, [::1] and its address.
  std::vector<std::string> hosts = {};
  /// Pages of other servers that may open sockets here, such as "https://app.foxglove.dev", and
  /// programs that call themselves so.
  std::vector<std::string> origins = {};
  std::string content_security_policy =
      "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
      "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; frame-ancestors 'none'";
  bool compress = false;  ///< Compresses WebSocket messages (permessage-deflate).
  Limits limits = {};
};

/// HTTP and the Foxglove WebSocket protocol (v1) on one port, by one thread of its own.
///
/// - A route answers first, then static files, then index.html for paths without a dot.
/// - `/ws/ID` is the socket of a session, `/ws` and `/` that of the newest.
/// - Requests whose Host is not this server, and upgrades and changes whose Origin is another, get
///   403.
class Server {
 public:
  /// Binds and listens. Throws ServerError when the address cannot be had.
  explicit Server(const ServerConfig& config);
  /// Stops.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  /// "" when none is needed.
  [[nodiscard]] const std::string& token() const;
  /// Where a browser finds it, the token included: "http://127.0.0.1:8080/".
  [[nodiscard]] std::string url() const;

  /// `pattern` is a path whose parts may be `{name}`, which matches any one part; a route without
  /// such parts is preferred. Only before `start`. Throws std::invalid_argument when there is such
  /// a route or the pattern does not begin with a slash.
  void route(Method method, std::string_view pattern, Handler handler, Accepts accepts = {});
  void route(Method method, std::string_view pattern, LaterHandler handler, Accepts accepts = {});

  /// Begins to serve.
  void start();
  /// Closes WebSockets with 1001, ends what is under way within Limits::stop_s, and joins the
  /// thread. Not from a handler. A server does not start again.
  void stop();

  /// Opens a session and marks it newest. Its id is what clients are told as the session's; one of
  /// letters, digits, `-`, `_` and `.`, else std::invalid_argument; also when it is open already.
  /// Sessions stay open until they are closed; from any thread.
  std::shared_ptr<Session> open_session(const std::string& id, const std::string& name);
  /// Closes its clients' sockets with 1001. Newest is then the one opened last of those that are
  /// left. Does nothing when there is no such session.
  void close_session(const std::string& id);
  /// Does nothing when there is no such session.
  void mark_newest(const std::string& id);

  [[nodiscard]] Counters counters() const;

 private:
  class Core;
  std::shared_ptr<Core> core_;
};

}  // namespace tacit::gateway
