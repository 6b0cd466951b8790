#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace tacit::gateway {

using Fields = std::map<std::string, std::string>;

struct Reply {
  int status = 0;
  Fields headers = {};  ///< Names in lower case.
  std::string body = {};
};

/// What a test asks for. `Host` is localhost unless `headers` says otherwise.
struct Ask {
  std::string method = "GET";
  std::string target = "/";
  Fields headers = {};
  std::string body = {};
};

/// One request on a connection of its own. Throws when no answer comes within 5 s.
[[nodiscard]] Reply ask(std::uint16_t port, const Ask& ask);
[[nodiscard]] Reply get(std::uint16_t port, const std::string& target, const Fields& headers = {});

/// Sends these bytes as they are, and gives all that comes until the server closes, at most for so
/// long. Absent when it does not close.
[[nodiscard]] std::optional<std::string> raw(std::uint16_t port, std::string_view bytes,
                                             double within_s = 5.0);
/// The same, but sends `then` after the server has answered with a header.
[[nodiscard]] std::optional<std::string> raw(std::uint16_t port, std::string_view bytes,
                                             std::string_view then, double within_s);

/// A WebSocket client. Each function throws when it takes more than 5 s or the socket closes.
class Socket {
 public:
  explicit Socket(std::uint16_t port, const std::string& target = "/ws",
                  const std::string& protocols = "foxglove.sdk.v1", const Fields& headers = {});
  ~Socket();

  [[nodiscard]] const std::string& protocol() const { return protocol_; }
  void say(const nlohmann::json& message);
  void say_binary(const std::string& bytes);
  void say_text(const std::string& text);

  struct Message {
    bool binary = false;
    std::string bytes;
    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(bytes); }
  };
  [[nodiscard]] Message next();
  /// The next JSON message of that op; others are skipped.
  [[nodiscard]] nlohmann::json next(const std::string& op);
  /// The next binary message of that opcode; others are skipped.
  [[nodiscard]] std::string next_binary(char opcode);
  /// True when nothing comes for so long.
  [[nodiscard]] bool is_quiet(double for_s);
  /// Reads until the server closes, and gives the close code; 0 when it just went.
  [[nodiscard]] int close_code();
  /// Closes without a word.
  void vanish();

 private:
  template <typename Start>
  boost::beast::error_code run(Start start, double within_s = 5.0);

  boost::asio::io_context io_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  boost::beast::flat_buffer buffer_;
  std::string protocol_;
};

/// Little-endian numbers in binary messages.
[[nodiscard]] std::uint64_t number_at(const std::string& bytes, std::size_t at, std::size_t size);
[[nodiscard]] std::string little(std::uint64_t number, std::size_t size);
/// A binary service request in JSON.
[[nodiscard]] std::string service_request(std::uint32_t service, std::uint32_t call,
                                          const std::string& json);

}  // namespace tacit::gateway
