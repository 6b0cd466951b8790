#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "console/gateway/server.h"
#include "tests/gateway/client.h"

namespace tacit::gateway {

inline std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

/// Waits up to 10 s until it holds; false when it does not.
inline bool comes_true(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

/// A server with one session, "run-1".
class SocketFixture : public ::testing::Test {
 protected:
  SocketFixture() = default;

  void begin(const Limits& limits = {}) {
    ServerConfig config;
    config.limits = limits;
    server_ = std::make_unique<Server>(config);
    session_ = server_->open_session("run-1", "First run");
    server_->start();
    port_ = server_->port();
  }

  static Channel channel(const std::string& topic, Keep keep = Keep::All) {
    return {topic, "cdr", "tacit/msg/Status", "uint32 tick", "ros2msg", keep};
  }

  void subscribe(Socket& socket, std::uint32_t id, ChannelId channel) {
    const std::size_t before = session_->subscribers(channel);
    socket.say({{"op", "subscribe"}, {"subscriptions", {{{"id", id}, {"channelId", channel}}}}});
    ASSERT_TRUE(comes_true([&] { return session_->subscribers(channel) == before + 1; }));
  }

  std::unique_ptr<Server> server_;
  std::shared_ptr<Session> session_;
  std::uint16_t port_ = 0;
};

}  // namespace tacit::gateway
