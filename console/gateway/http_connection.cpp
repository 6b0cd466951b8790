#include "console/gateway/http_connection.h"

#include <array>
#include <boost/asio/post.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>
#include <utility>

#include "console/gateway/websocket_connection.h"

namespace tacit::gateway {
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using beast::error_code;

namespace {

/// How long and how much is still read of a client that was told to go, so that it gets to read
/// the answer before the connection is reset.
constexpr double kLinger_s = 1.0;
constexpr std::size_t kLingerBytes = 1U << 24U;
/// Of files that clients fetch slowly.
constexpr double kSlowest_bytes_per_s = 65536.0;

std::optional<Method> method_of(http::verb verb) {
  switch (verb) {
    case http::verb::get:
    case http::verb::head:
      return Method::Get;
    case http::verb::post:
      return Method::Post;
    case http::verb::put:
      return Method::Put;
    case http::verb::delete_:
      return Method::Delete;
    default:
      return std::nullopt;
  }
}

Response malformed(error_code ec) {
  if (ec == http::error::body_limit) {
    return error(413, "the body is too large");
  }
  if (ec == http::error::header_limit) {
    return error(431, "the header is too large");
  }
  return error(400, "this is no HTTP request");
}

class HttpConnection final : public Connection,
                             public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(const std::shared_ptr<Hub>& hub, asio::ip::tcp::socket socket, Ticket ticket)
      : weak_hub_(hub), hub_(*hub), stream_(std::move(socket)), ticket_(std::move(ticket)) {}

  void begin() {
    hub_.connections.insert(shared_from_this());
    read_header(hub_.config.limits.header_s);
  }

  void tick(Clock::time_point now) override {
    if (waits_ && now - waits_since_ > seconds(hub_.config.limits.answer_s)) {
      keep_alive_ = false;
      answer(error(504, "the answer took too long"));
    }
  }

  void shut() override {
    keep_alive_ = false;
    if (idle_) {
      end();
    }
  }

  void abandon() override { end(); }

 private:
  using Parser = http::request_parser<http::string_body>;
  using Header = http::response_header<>;

  void read_header(double within_s) {
    idle_ = true;
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(hub_.config.limits.header_bytes));
    parser_->body_limit(hub_.config.limits.body_bytes);
    stream_.expires_after(seconds(within_s));
    http::async_read_header(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](error_code ec, std::size_t) { self->on_header(ec); });
  }

  void on_header(error_code ec) {
    idle_ = false;
    if (ec) {
      return on_failed_read(ec);
    }
    keep_alive_ = parser_->keep_alive() && !hub_.stopping;
    if (!ticket_) {
      return refuse(error(503, "there are too many connections"));
    }
    if (!read_request()) {
      return;
    }
    const bool upgrade = beast::websocket::is_upgrade(parser_->get());
    if (auto refusal = hub_.desk.refusal(request_, upgrade || request_.method != Method::Get)) {
      return refuse(std::move(*refusal));
    }
    if (upgrade) {
      return on_upgrade();
    }
    stream_.expires_after(seconds(hub_.config.limits.body_s));
    http::async_read(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](error_code failed, std::size_t) { self->on_body(failed); });
  }

  void on_failed_read(error_code ec) {
    const bool is_theirs = ec.category() == make_error_code(http::error::body_limit).category();
    if (is_theirs && ec != http::error::end_of_stream && ec != http::error::partial_message) {
      return refuse(malformed(ec));
    }
    end();
  }

  /// Of what comes before the body. False when that was answered already.
  bool read_request() {
    const auto& message = parser_->get();
    raw_target_ = std::string(message.target());
    const auto target = parse_target(raw_target_);
    const auto method = method_of(message.method());
    if (!target) {
      refuse(error(400, "the address cannot be read"));
      return false;
    }
    if (!method) {
      refuse(not_allowed({"GET", "HEAD", "POST", "PUT", "DELETE"}));
      return false;
    }
    request_ = {};
    request_.method = *method;
    request_.path = target->path();
    request_.query = target->query;
    for (const auto& field : message) {
      request_.headers.emplace_back(lower_case(field.name_string()), field.value());
    }
    return true;
  }

  void on_body(error_code ec) {
    if (ec) {
      return on_failed_read(ec);
    }
    request_.body = std::move(parser_->get().body());
    waits_ = true;
    waits_since_ = Clock::now();
    auto response = hub_.desk.answer(request_, raw_target_, [this] { return responder(); });
    if (response) {
      answer(std::move(*response));
    }
  }

  Responder responder() {
    return Responder([hub = weak_hub_, me = weak_from_this(), number = number_](Response response) {
      if (const auto alive = hub.lock()) {
        asio::post(alive->io, [me, number, response = std::move(response)]() mutable {
          const auto self = me.lock();
          if (self && self->waits_ && self->number_ == number) {
            self->answer(std::move(response));
          }
        });
      }
    });
  }

  void on_upgrade() {
    const auto protocol = chosen_protocol(parser_->get()[http::field::sec_websocket_protocol]);
    if (!protocol) {
      return refuse(error(400, "none of the offered sub-protocols is spoken here",
                          "foxglove.sdk.v1 or foxglove.websocket.v1"));
    }
    auto session = hub_.sessions.at(parse_target(raw_target_)->parts);
    if (!session) {
      return refuse(error(404, "there is no session at " + request_.path, "/ws/ID, or /ws"));
    }
    count(101);
    hub_.connections.erase(shared_from_this());
    serve_websocket(weak_hub_.lock(), {std::move(stream_), parser_->release(), *protocol,
                                       std::move(session), std::move(ticket_)});
  }

  /// Answers and closes: what the client goes on to send is not looked at.
  void refuse(Response response) {
    keep_alive_ = false;
    answer(std::move(response));
  }

  void answer(Response response) {
    waits_ = false;
    ++number_;
    if (!response.file.empty() && answer_by_file(response)) {
      return;
    }
    http::response<http::string_body> message(header_of(response));
    const bool has_body = response.status != 304 && response.status != 204;
    const std::size_t size = response.body.size();
    if (has_body && !is_head()) {
      message.body() = std::move(response.body);
    }
    if (has_body) {
      message.content_length(size);
    }
    write(std::move(message), 0);
  }

  /// False, and `response` says why, when the file cannot be opened.
  bool answer_by_file(Response& response) {
    http::file_body::value_type file;
    error_code ec;
    file.open(response.file.c_str(), beast::file_mode::scan, ec);
    if (ec) {
      response = error(404, "the file cannot be read");
      return false;
    }
    const std::uint64_t size = file.size();
    if (is_head()) {
      http::response<http::empty_body> message(header_of(response));
      message.content_length(size);
      write(std::move(message), 0);
      return true;
    }
    http::response<http::file_body> message(header_of(response));
    message.body() = std::move(file);
    message.content_length(size);
    write(std::move(message), size);
    return true;
  }

  bool is_head() const { return parser_ && parser_->get().method() == http::verb::head; }

  Header header_of(const Response& response) {
    count(response.status);
    Header header;
    header.version(11);
    header.result(static_cast<unsigned>(response.status));
    header.set(http::field::content_type, response.content_type);
    header.set("X-Content-Type-Options", "nosniff");
    header.set("Content-Security-Policy", hub_.config.content_security_policy);
    header.set("Referrer-Policy", "no-referrer");
    header.set("Cross-Origin-Resource-Policy", "same-origin");
    header.set(http::field::cache_control, "no-store");
    for (const auto& [name, value] : response.headers) {
      header.set(name, value);
    }
    header.set(http::field::connection, keep_alive_ ? "keep-alive" : "close");
    return header;
  }

  template <typename Message>
  void write(Message message, std::uint64_t file_size) {
    stream_.expires_after(
        seconds(hub_.config.limits.body_s + static_cast<double>(file_size) / kSlowest_bytes_per_s));
    beast::async_write(
        stream_, http::message_generator(std::move(message)),
        [self = shared_from_this()](error_code ec, std::size_t) { self->on_written(ec); });
  }

  void on_written(error_code ec) {
    if (ec) {
      end();
    } else if (keep_alive_) {
      read_header(hub_.config.limits.idle_s);
    } else {
      stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ec);
      stream_.expires_after(seconds(kLinger_s));
      linger(0);
    }
  }

  void linger(std::size_t read) {
    stream_.async_read_some(asio::buffer(leftovers_), [self = shared_from_this(), read](
                                                          error_code ec, std::size_t more) {
      return ec || read + more > kLingerBytes ? self->end() : self->linger(read + more);
    });
  }

  void count(int status) {
    const auto index = static_cast<std::size_t>(status);
    if (index < hub_.tally->requests.size()) {
      ++hub_.tally->requests.at(index);
    }
  }

  void end() {
    waits_ = false;
    error_code ignored;
    stream_.socket().close(ignored);
    hub_.connections.erase(shared_from_this());
  }

  const std::weak_ptr<Hub> weak_hub_;
  Hub& hub_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  Ticket ticket_;  ///< Empty: one too many.
  std::optional<Parser> parser_;
  std::string raw_target_;
  Request request_;
  bool idle_ = true;  ///< Between requests.
  bool keep_alive_ = false;
  bool waits_ = false;  ///< For a handler's answer.
  Clock::time_point waits_since_;
  std::uint64_t number_ = 0;  ///< Of the request, so that late answers to others do not count.
  std::array<char, 4096> leftovers_{};
};

}  // namespace

void serve_http(const std::shared_ptr<Hub>& hub, asio::ip::tcp::socket socket) {
  std::make_shared<HttpConnection>(hub, std::move(socket), Ticket(hub->tally))->begin();
}

void serve_refusal(const std::shared_ptr<Hub>& hub, asio::ip::tcp::socket socket) {
  ++hub->tally->connections_refused;
  std::make_shared<HttpConnection>(hub, std::move(socket), Ticket())->begin();
}

}  // namespace tacit::gateway
