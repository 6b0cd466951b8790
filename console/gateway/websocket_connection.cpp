#include "console/gateway/websocket_connection.h"

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <cmath>
#include <utility>

#include "console/gateway/client_words.h"

namespace tacit::gateway {
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using beast::error_code;

namespace {

/// What waits for a slow client waits with us, where it can be dropped, and not in the kernel.
constexpr int kSendBufferBytes = 1 << 18;

class WebSocketConnection final : public Connection,
                                  public std::enable_shared_from_this<WebSocketConnection> {
 public:
  WebSocketConnection(const std::shared_ptr<Hub>& hub, Upgrade upgrade)
      : weak_hub_(hub),
        hub_(*hub),
        socket_(std::move(upgrade.stream)),
        request_(std::move(upgrade.request)),
        protocol_(std::move(upgrade.protocol)),
        session_(std::move(upgrade.session)),
        ticket_(std::move(upgrade.ticket)),
        delay_(hub->io),
        allowance_(hub->config.limits.messages_per_s) {}

  void begin() {
    hub_.connections.insert(shared_from_this());
    configure();
    socket_.async_accept(request_,
                         [self = shared_from_this()](error_code ec) { self->on_accepted(ec); });
  }

  void tick(Clock::time_point now) override {
    if (writing_ && now - writing_since_ > seconds(hub_.config.limits.stalled_s)) {
      give_up();
    }
  }

  void shut() override { say_goodbye(websocket::close_code::going_away); }

  void abandon() override { end(); }

 private:
  void configure() {
    const Limits& limits = hub_.config.limits;
    // The WebSocket keeps its own time from here on.
    beast::get_lowest_layer(socket_).expires_never();
    auto& tcp = beast::get_lowest_layer(socket_).socket();
    error_code ignored;
    tcp.set_option(asio::ip::tcp::no_delay(true), ignored);
    tcp.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = seconds(limits.header_s);
    timeout.idle_timeout = seconds(limits.silence_s);
    timeout.keep_alive_pings = true;
    socket_.set_option(timeout);
    socket_.set_option(websocket::stream_base::decorator(
        [protocol = protocol_](websocket::response_type& response) {
          response.set(http::field::sec_websocket_protocol, protocol);
        }));
    websocket::permessage_deflate deflate;
    deflate.server_enable = hub_.config.compress;
    socket_.set_option(deflate);
    socket_.read_message_max(limits.message_bytes);
    socket_.auto_fragment(false);
  }

  void on_accepted(error_code ec) {
    if (ec || ended_) {
      return end();
    }
    open_ = true;
    ++hub_.tally->websockets_open;
    ++hub_.tally->websockets_total;
    if (hub_.stopping) {
      return shut();
    }
    client_ = session_->join([hub = weak_hub_, me = weak_from_this()] {
      if (const auto alive = hub.lock()) {
        asio::post(alive->io, [me] {
          if (const auto self = me.lock()) {
            self->on_woken();
          }
        });
      }
    });
    if (!client_) {
      return shut();
    }
    read();
  }

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](error_code ec, std::size_t size) {
      self->on_read(ec, size);
    });
  }

  void on_read(error_code ec, std::size_t size) {
    if (ec || ended_) {
      return end();
    }
    ++hub_.tally->messages_received;
    hub_.tally->bytes_received += size;
    if (!closing_) {
      hear();
    }
    buffer_.consume(buffer_.size());
    wait_and_read();
  }

  void hear() {
    const auto bytes = buffer_.cdata();
    const auto* data = static_cast<const std::uint8_t*>(bytes.data());
    if (socket_.got_binary()) {
      hear_binary(*session_, client_, {data, bytes.size()});
    } else {
      hear_text(*session_, client_, {reinterpret_cast<const char*>(data), bytes.size()});
    }
  }

  /// A client that says too much is listened to more slowly; TCP holds it up.
  void wait_and_read() {
    const double rate = hub_.config.limits.messages_per_s;
    const Clock::time_point now = Clock::now();
    const double passed_s = std::chrono::duration<double>(now - refilled_).count();
    allowance_ = std::min(rate, allowance_ + passed_s * rate) - 1.0;
    refilled_ = now;
    if (allowance_ >= 0.0) {
      return read();
    }
    delay_.expires_after(seconds(-allowance_ / rate));
    delay_.async_wait([self = shared_from_this()](error_code ec) {
      if (!ec && !self->ended_) {
        self->read();
      }
    });
  }

  void on_woken() {
    if (ended_) {
      return;
    }
    switch (session_->fate(client_)) {
      case SessionState::Fate::Stalled:
        return give_up();
      case SessionState::Fate::Go:
        return say_goodbye(websocket::close_code::going_away);
      case SessionState::Fate::Stay:
        break;
    }
    if (!writing_) {
      write();
    }
  }

  void write() {
    auto next = session_->next(client_);
    if (!next || closing_) {
      return;
    }
    frame_ = std::move(*next);
    writing_ = true;
    writing_since_ = Clock::now();
    socket_.binary(frame_.binary);
    const std::array<asio::const_buffer, 2> parts{
        asio::buffer(frame_.head_bytes.data(), frame_.head_size),
        asio::buffer(frame_.body.data(), frame_.body.size())};
    socket_.async_write(parts, [self = shared_from_this()](error_code ec, std::size_t size) {
      self->on_written(ec, size);
    });
  }

  void on_written(error_code ec, std::size_t size) {
    writing_ = false;
    if (ec || ended_) {
      return end();
    }
    ++hub_.tally->messages_sent;
    hub_.tally->bytes_sent += size;
    if (!closing_) {
      on_woken();
    }
  }

  void say_goodbye(websocket::close_code code) {
    if (!open_) {
      return end();
    }
    if (closing_ || ended_) {
      return;
    }
    closing_ = true;
    socket_.async_close(code, [self = shared_from_this()](error_code) { self->end(); });
  }

  void give_up() {
    ++hub_.tally->websockets_stalled;
    end();
  }

  void end() {
    if (ended_) {
      return;
    }
    ended_ = true;
    if (open_) {
      --hub_.tally->websockets_open;
    }
    if (client_) {
      session_->leave(client_);
    }
    delay_.cancel();
    error_code ignored;
    beast::get_lowest_layer(socket_).socket().close(ignored);
    hub_.connections.erase(shared_from_this());
  }

  const std::weak_ptr<Hub> weak_hub_;
  Hub& hub_;
  websocket::stream<beast::tcp_stream> socket_;
  const http::request<http::string_body> request_;
  const std::string protocol_;
  const std::shared_ptr<SessionState> session_;
  const Ticket ticket_;
  ClientPtr client_;
  beast::flat_buffer buffer_;
  Frame frame_;  ///< That is being written.
  bool open_ = false;
  bool writing_ = false;
  bool closing_ = false;
  bool ended_ = false;
  Clock::time_point writing_since_;
  asio::steady_timer delay_;
  double allowance_;  ///< Messages that may be read at once.
  Clock::time_point refilled_ = Clock::now();
};

}  // namespace

std::optional<std::string> chosen_protocol(std::string_view offered) {
  for (const std::string known : {"foxglove.sdk.v1", "foxglove.websocket.v1"}) {
    if (http::token_list(offered).exists(known)) {
      return known;
    }
  }
  return std::nullopt;
}

void serve_websocket(const std::shared_ptr<Hub>& hub, Upgrade upgrade) {
  std::make_shared<WebSocketConnection>(hub, std::move(upgrade))->begin();
}

}  // namespace tacit::gateway
