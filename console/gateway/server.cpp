#include "console/gateway/server.h"

#include <pthread.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cassert>
#include <csignal>
#include <thread>

#include "console/gateway/guard.h"
#include "console/gateway/http_connection.h"
#include "console/gateway/hub.h"

namespace tacit::gateway {
namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr double kTick_s = 0.1;
/// Connections beyond the limit that are told so; those beyond these are just closed.
constexpr std::size_t kRefusals = 32;

ServerConfig completed(ServerConfig config) {
  if (config.address == "localhost") {
    config.address = "127.0.0.1";
  }
  if (config.token.empty() && !is_loopback(config.address)) {
    config.token = new_token();
  }
  return config;
}

}  // namespace

/// Accepts connections, on a thread of its own.
class Server::Core : public std::enable_shared_from_this<Server::Core> {
 public:
  explicit Core(const ServerConfig& config)
      : hub(std::make_shared<Hub>(completed(config))), acceptor_(hub->io), ticker_(hub->io) {
    error_code ec;
    const auto address = asio::ip::make_address(hub->config.address, ec);
    if (ec) {
      throw ServerError("no address: " + hub->config.address);
    }
    try {
      const tcp::endpoint endpoint(address, hub->config.port);
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
      port = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& failure) {
      throw ServerError(hub->config.address + ':' + std::to_string(hub->config.port) + ": " +
                        failure.code().message());
    }
  }

  void start() {
    accept();
    tick();
    // Signals are for the program's other threads.
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread_ = std::thread([this] { hub->io.run(); });
    pthread_setname_np(thread_.native_handle(), "gateway");
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  bool is_started() const { return thread_.joinable(); }

  void stop() {
    if (thread_.joinable()) {
      asio::post(hub->io, [this] { begin_stop(); });
      thread_.join();
    }
    // Some may not have gone in time. From here on no thread that publishes finds one of them.
    for (const auto& connection : std::set(hub->connections)) {
      connection->abandon();
    }
    error_code ignored;
    acceptor_.close(ignored);
  }

  const std::shared_ptr<Hub> hub;
  std::uint16_t port = 0;

 private:
  void accept() {
    acceptor_.async_accept([this](error_code ec, tcp::socket socket) {
      if (hub->stopping) {
        return;
      }
      if (ec) {
        paused_ = true;  // Out of file descriptors, likely: again at the next tick.
        return;
      }
      take(std::move(socket));
      accept();
    });
  }

  void take(tcp::socket socket) {
    const std::size_t most = hub->config.limits.connections;
    if (hub->tally->connections_open < most) {
      serve_http(hub, std::move(socket));
    } else if (hub->connections.size() < most + kRefusals) {
      serve_refusal(hub, std::move(socket));
    } else {
      ++hub->tally->connections_refused;
    }
  }

  void tick() {
    ticker_.expires_after(seconds(kTick_s));
    ticker_.async_wait([this](error_code ec) {
      if (!ec) {
        on_tick();
      }
    });
  }

  void on_tick() {
    const Clock::time_point now = Clock::now();
    for (const auto& connection : std::set(hub->connections)) {
      connection->tick(now);
    }
    if (hub->stopping && (hub->connections.empty() || now > stop_by_)) {
      hub->io.stop();
      return;
    }
    if (std::exchange(paused_, false)) {
      accept();
    }
    tick();
  }

  void begin_stop() {
    hub->stopping = true;
    stop_by_ = Clock::now() + seconds(hub->config.limits.stop_s);
    error_code ignored;
    acceptor_.close(ignored);
    for (const auto& connection : std::set(hub->connections)) {
      connection->shut();
    }
    if (hub->connections.empty()) {
      hub->io.stop();
    }
  }

  tcp::acceptor acceptor_;
  asio::steady_timer ticker_;
  std::thread thread_;
  bool paused_ = false;  ///< Does not accept.
  Clock::time_point stop_by_;
};

Server::Server(const ServerConfig& config) : core_(std::make_shared<Core>(config)) {}

Server::~Server() { stop(); }

std::uint16_t Server::port() const { return core_->port; }

const std::string& Server::token() const { return core_->hub->config.token; }

std::string Server::url() const {
  const std::string& address = core_->hub->config.address;
  const std::string host = address == "0.0.0.0" ? "127.0.0.1" : address == "::" ? "::1" : address;
  const bool is_v6 = host.find(':') != std::string::npos;
  return "http://" + (is_v6 ? '[' + host + ']' : host) + ':' + std::to_string(port()) + '/' +
         (token().empty() ? "" : "?token=" + token());
}

void Server::route(Method method, std::string_view pattern, Handler handler, Accepts accepts) {
  assert(!core_->is_started());
  core_->hub->desk.router().add(method, pattern, std::move(handler), std::move(accepts));
}

void Server::route(Method method, std::string_view pattern, LaterHandler handler, Accepts accepts) {
  assert(!core_->is_started());
  core_->hub->desk.router().add(method, pattern, std::move(handler), std::move(accepts));
}

void Server::start() {
  assert(!core_->is_started() && !core_->hub->stopping);
  core_->start();
}

void Server::stop() { core_->stop(); }

std::shared_ptr<Session> Server::open_session(const std::string& id, const std::string& name) {
  Hub& hub = *core_->hub;
  return std::make_shared<Session>(hub.sessions.open(id, name, hub.config.limits, hub.tally));
}

void Server::close_session(const std::string& id) { core_->hub->sessions.close(id); }

void Server::mark_newest(const std::string& id) { core_->hub->sessions.mark_newest(id); }

Counters Server::counters() const { return core_->hub->tally->read(); }

}  // namespace tacit::gateway
