#include "console/gateway/guard.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "console/gateway/server.h"
#include "tests/gateway/client.h"

namespace tacit::gateway {
namespace {

class GuardTest : public ::testing::Test {
 protected:
  void begin(const ServerConfig& config) {
    server_.emplace(config);
    server_->route(Method::Get, "/api/runs", [](const Request&) { return json("[]"); });
    server_->route(Method::Post, "/api/runs", [](const Request&) { return json("{}"); });
    server_->open_session("run", "Run");
    server_->start();
    port_ = server_->port();
    here_ = "http://localhost:" + std::to_string(port_);
  }
  int status(const std::string& target, const Fields& headers, const std::string& method = "GET") {
    return ask(port_, {method, target, headers}).status;
  }
  bool has_socket(const std::string& target, const Fields& headers) {
    try {
      Socket socket(port_, target, "foxglove.sdk.v1", headers);
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  }

  std::optional<Server> server_;
  std::uint16_t port_ = 0;
  std::string here_;
};

TEST_F(GuardTest, OnlyRequestsForThisHostAreAnswered) {
  ServerConfig config;
  config.hosts = {"robots.lab"};
  begin(config);
  for (const std::string host :
       {"localhost", "LocalHost:99", "127.0.0.1:8080", "[::1]:80", "robots.lab:8080"}) {
    EXPECT_EQ(status("/api/runs", {{"Host", host}}), 200) << host;
  }
  for (const std::string host : {"evil.example", "localhost.evil.example", "127.0.0.1.evil.example",
                                 "10.0.0.1", "", "[::1].evil.example"}) {
    EXPECT_EQ(status("/api/runs", {{"Host", host}}), 403) << host;
    EXPECT_EQ(status("/", {{"Host", host}}), 403) << host;
  }
  EXPECT_FALSE(has_socket("/ws", {{"Host", "evil.example"}}));
}

TEST_F(GuardTest, PagesOfOtherServersChangeNothingAndGetNoSocket) {
  ServerConfig config;
  config.origins = {"https://app.foxglove.dev"};
  begin(config);
  for (const std::string& origin : {here_, std::string("https://app.foxglove.dev")}) {
    EXPECT_EQ(status("/api/runs", {{"Origin", origin}}, "POST"), 200) << origin;
    EXPECT_TRUE(has_socket("/ws", {{"Origin", origin}})) << origin;
  }
  for (const std::string origin : {"http://evil.example", "null", "http://localhost:1", "file://",
                                   "https://app.foxglove.dev.evil.example"}) {
    EXPECT_EQ(status("/api/runs", {{"Origin", origin}}, "POST"), 403) << origin;
    EXPECT_EQ(status("/api/runs", {{"Origin", origin}}), 200) << origin;
    EXPECT_FALSE(has_socket("/ws", {{"Origin", origin}})) << origin;
  }
}

TEST_F(GuardTest, ATokenIsAskedForInHeaderQueryOrCookie) {
  ServerConfig config;
  config.token = "sesame";
  begin(config);
  EXPECT_EQ(status("/api/runs", {}), 401);
  EXPECT_EQ(status("/", {}), 401);
  EXPECT_EQ(status("/api/runs", {{"Authorization", "Bearer sesame"}}), 200);
  EXPECT_EQ(status("/api/runs", {{"Authorization", "Bearer sesam"}}), 401);
  EXPECT_EQ(status("/api/runs", {{"Authorization", "Bearer sesame2"}}), 401);
  EXPECT_EQ(status("/api/runs?token=sesame", {}), 200);
  EXPECT_EQ(status("/api/runs", {{"Cookie", "a=b; gateway_token=sesame"}}), 200);
  EXPECT_EQ(status("/api/runs", {{"Cookie", "gateway_token=other; x"}}), 401);
  EXPECT_FALSE(has_socket("/ws", {}));
  EXPECT_TRUE(has_socket("/ws?token=sesame", {}));
  EXPECT_TRUE(has_socket("/ws", {{"Authorization", "Bearer sesame"}}));
}

TEST_F(GuardTest, ATokenInAPagesAddressBecomesACookie) {
  ServerConfig config;
  config.token = "sesame";
  begin(config);
  const Reply reply = get(port_, "/runs/1?token=sesame");
  EXPECT_EQ(reply.status, 303);
  EXPECT_EQ(reply.headers.at("location"), "/runs/1");
  EXPECT_EQ(reply.headers.at("set-cookie"),
            "gateway_token=sesame; Path=/; HttpOnly; SameSite=Strict");
  EXPECT_EQ(get(port_, "//evil.example/?token=sesame").headers.at("location"), "/");
  EXPECT_EQ(server_->url(), "http://127.0.0.1:" + std::to_string(port_) + "/?token=sesame");
}

TEST_F(GuardTest, ATokenIsMadeUpWhereStrangersCanReachTheServer) {
  ServerConfig config;
  config.address = "0.0.0.0";
  begin(config);
  EXPECT_EQ(server_->token().size(), 32U);
  EXPECT_NE(server_->token(), Server(config).token());
  EXPECT_EQ(status("/api/runs", {}), 401);
  EXPECT_EQ(status("/api/runs",
                   {{"Authorization", "Bearer " + server_->token()}, {"Host", "192.168.1.5:8080"}}),
            200);
  EXPECT_EQ(status("/api/runs",
                   {{"Authorization", "Bearer " + server_->token()}, {"Host", "evil.example"}}),
            403);
}

TEST(Loopback, IsTheMachineItself) {
  EXPECT_TRUE(is_loopback("127.0.0.1"));
  EXPECT_TRUE(is_loopback("127.1.2.3"));
  EXPECT_TRUE(is_loopback("::1"));
  EXPECT_FALSE(is_loopback("127.evil.example"));
  EXPECT_FALSE(is_loopback("0.0.0.0"));
  EXPECT_FALSE(is_loopback("192.168.0.1"));
}

}  // namespace
}  // namespace tacit::gateway
