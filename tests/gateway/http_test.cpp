#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "console/gateway/server.h"
#include "tests/gateway/client.h"

namespace tacit::gateway {
namespace {

class Http : public ::testing::Test {
 protected:
  Server& begin(const ServerConfig& config = {}) {
    server_.emplace(config);
    server_->route(Method::Get, "/api/runs", [](const Request&) { return json("[1,2]"); });
    server_->route(Method::Get, "/api/runs/{id}", [](const Request& request) {
      return json('"' + std::string(request.parameter("id")) + '|' +
                  std::string(request.in_query("what")) + '"');
    });
    server_->route(Method::Get, "/api/runs/newest",
                   [](const Request&) { return json("\"the newest\""); });
    server_->route(Method::Post, "/api/runs",
                   [](const Request& request) { return json(request.body); });
    server_->route(Method::Delete, "/api/runs/{id}", [](const Request&) -> Response {
      throw std::runtime_error("it cannot be removed");
    });
    server_->route(Method::Get, "/api/later", [this](const Request&, Responder responder) {
      answering_ = std::thread([responder] { responder(json("\"at last\"")); });
    });
    server_->route(Method::Get, "/api/forgotten", [](const Request&, const Responder&) {});
    server_->route(Method::Get, "/api/never",
                   [this](const Request&, const Responder& responder) { kept_ = responder; });
    server_->start();
    port_ = server_->port();
    return *server_;
  }
  ~Http() override {
    if (answering_.joinable()) {
      answering_.join();
    }
  }
  Reply post(const std::string& body, const Fields& headers) {
    return ask(port_, {"POST", "/api/runs", headers, body});
  }

  std::optional<Responder> kept_;
  std::optional<Server> server_;
  std::uint16_t port_ = 0;
  std::thread answering_;
};

TEST_F(Http, ARouteAnswersWithItsParametersAndQueryDecoded) {
  begin();
  EXPECT_EQ(get(port_, "/api/runs").body, "[1,2]");
  const Reply reply = get(port_, "/api/runs/a%20b?what=c+d%26&x");
  EXPECT_EQ(reply.status, 200);
  EXPECT_EQ(reply.body, "\"a b|c d&\"");
  EXPECT_EQ(reply.headers.at("content-type"), "application/json");
}

TEST_F(Http, ARouteWithoutParametersIsPreferred) {
  begin();
  EXPECT_EQ(get(port_, "/api/runs/newest").body, "\"the newest\"");
}

TEST_F(Http, EveryAnswerForbidsGuessingTypesAndForeignContent) {
  begin();
  const Reply reply = get(port_, "/api/runs");
  EXPECT_EQ(reply.headers.at("x-content-type-options"), "nosniff");
  EXPECT_NE(reply.headers.at("content-security-policy").find("default-src 'self'"),
            std::string::npos);
  EXPECT_EQ(reply.headers.at("cache-control"), "no-store");
}

TEST_F(Http, WhatIsNotThereIs404AsJson) {
  begin();
  const Reply reply = get(port_, "/api/robots");
  EXPECT_EQ(reply.status, 404);
  EXPECT_EQ(nlohmann::json::parse(reply.body).at("error"), "there is nothing at /api/robots");
}

TEST_F(Http, AWrongMethodIs405AndSaysWhichAreRight) {
  begin();
  const Reply reply = ask(port_, {.method = "PUT", .target = "/api/runs"});
  EXPECT_EQ(reply.status, 405);
  EXPECT_EQ(reply.headers.at("allow"), "GET, POST");
  EXPECT_EQ(ask(port_, {.method = "BREW", .target = "/api/runs"}).status, 405);
  EXPECT_EQ(ask(port_, {.method = "POST", .target = "/index.html"}).status, 405);
}

TEST_F(Http, HeadHasTheLengthAndNoBody) {
  begin();
  const Reply reply = ask(port_, {.method = "HEAD", .target = "/api/runs"});
  EXPECT_EQ(reply.status, 200);
  EXPECT_EQ(reply.headers.at("content-length"), "5");
  EXPECT_EQ(reply.body, "");
}

TEST_F(Http, ABodyOfAnotherTypeIs415) {
  begin();
  EXPECT_EQ(post("{}", {{"Content-Type", "application/json; charset=utf-8"}}).body, "{}");
  const Reply reply = post("a=b", {{"Content-Type", "application/x-www-form-urlencoded"}});
  EXPECT_EQ(reply.status, 415);
  EXPECT_EQ(nlohmann::json::parse(reply.body).at("wanted"), "application/json");
  EXPECT_EQ(post("{}", {}).status, 415);
  EXPECT_EQ(post("", {}).status, 200);
}

TEST_F(Http, ABodyTooLargeIs413) {
  ServerConfig config;
  config.limits.body_bytes = 100;
  begin(config);
  const Fields type{{"Content-Type", "application/json"}};
  EXPECT_EQ(post(std::string(100, ' '), type).status, 200);
  EXPECT_EQ(post(std::string(101, ' '), type).status, 413);
  EXPECT_EQ(post(std::string(5'000'000, ' '), type).status, 413);
  const auto chunked = raw(port_,
                           "POST /api/runs HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                           "application/json\r\nTransfer-Encoding: chunked\r\n\r\n100\r\n" +
                               std::string(256, ' ') + "\r\n0\r\n\r\n");
  ASSERT_TRUE(chunked);
  EXPECT_EQ(chunked->substr(0, 12), "HTTP/1.1 413");
}

TEST_F(Http, AHeaderTooLargeIs431) {
  begin();
  EXPECT_EQ(get(port_, "/", {{"X-Long", std::string(20000, 'x')}}).status, 431);
}

TEST_F(Http, WhatIsNoRequestIs400) {
  begin();
  for (const std::string bytes :
       {"GARBAGE\r\n\r\n", "GET / HTTP/9.9\r\n\r\n", "GET /%zz HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "GET /%00 HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "GET http://localhost/ HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: -1\r\n\r\n"}) {
    const auto answer = raw(port_, bytes);
    ASSERT_TRUE(answer) << bytes;
    EXPECT_EQ(answer->substr(0, 12), "HTTP/1.1 400") << bytes;
  }
}

TEST_F(Http, WhatAHandlerThrowsIs500) {
  begin();
  const Reply reply = ask(port_, {.method = "DELETE", .target = "/api/runs/1"});
  EXPECT_EQ(reply.status, 500);
  EXPECT_EQ(nlohmann::json::parse(reply.body).at("error"), "it cannot be removed");
}

TEST_F(Http, AnAnswerMayComeLaterFromAnotherThread) {
  begin();
  EXPECT_EQ(get(port_, "/api/later").body, "\"at last\"");
}

TEST_F(Http, AnAnswerThatIsForgottenIs500) {
  begin();
  EXPECT_EQ(get(port_, "/api/forgotten").status, 500);
}

TEST_F(Http, AnAnswerThatDoesNotComeIs504AndOneAfterwardsIsIgnored) {
  ServerConfig config;
  config.limits.answer_s = 0.2;
  begin(config);
  EXPECT_EQ(get(port_, "/api/never").status, 504);
  (*kept_)(json("1"));
  EXPECT_EQ(get(port_, "/api/runs").status, 200);
  server_.reset();
  (*kept_)(json("1"));
}

TEST_F(Http, AConnectionServesSeveralRequests) {
  begin();
  const std::string one = "GET /api/runs HTTP/1.1\r\nHost: localhost\r\n";
  const auto answers = raw(port_, one + "\r\n" + one + "\r\n" + one + "Connection: close\r\n\r\n");
  ASSERT_TRUE(answers);
  std::size_t count = 0;
  for (std::size_t at = 0; (at = answers->find("HTTP/1.1 200", at)) != std::string::npos; ++at) {
    ++count;
  }
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(server_->counters().connections_total, 1U);
}

TEST_F(Http, AHeaderThatDoesNotEndIsNotWaitedFor) {
  ServerConfig config;
  config.limits.header_s = 0.3;
  begin(config);
  EXPECT_EQ(raw(port_, "GET / HTTP/1.1\r\nHost: loc", 3.0), "");
}

TEST_F(Http, ABodyThatDoesNotEndIsNotWaitedFor) {
  ServerConfig config;
  config.limits.body_s = 0.3;
  begin(config);
  EXPECT_EQ(raw(port_,
                "POST /api/runs HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9\r\n"
                "Content-Type: application/json\r\n\r\n{",
                3.0),
            "");
}

TEST_F(Http, AnIdleConnectionIsClosed) {
  ServerConfig config;
  config.limits.idle_s = 0.3;
  begin(config);
  const auto answer = raw(port_, "GET /api/runs HTTP/1.1\r\nHost: localhost\r\n\r\n", 3.0);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->ends_with("[1,2]"));
}

TEST_F(Http, ConnectionsBeyondTheLimitAre503) {
  ServerConfig config;
  config.limits.connections = 2;
  begin(config);
  server_->open_session("one", "One");
  {
    const Socket first(port_);
    const Socket second(port_);
    EXPECT_EQ(get(port_, "/api/runs").status, 503);
    EXPECT_EQ(server_->counters().connections_refused, 1U);
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (server_->counters().connections_open > 0 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(get(port_, "/api/runs").status, 200);
}

TEST_F(Http, RequestsAreCountedByTheirStatus) {
  begin();
  EXPECT_EQ(get(port_, "/api/runs").status, 200);
  EXPECT_EQ(get(port_, "/api/runs").status, 200);
  EXPECT_EQ(get(port_, "/api/robots").status, 404);
  const Counters counters = server_->counters();
  EXPECT_EQ(counters.requests_by_status.at(200), 2U);
  EXPECT_EQ(counters.requests_by_status.at(404), 1U);
  EXPECT_EQ(counters.connections_total, 3U);
}

TEST_F(Http, TheSameRouteTwiceIsRefused) {
  Server server({});
  const auto handler = [](const Request&) { return json("1"); };
  server.route(Method::Get, "/a", handler);
  server.route(Method::Post, "/a", handler);
  EXPECT_THROW(server.route(Method::Get, "/a", handler), std::invalid_argument);
  EXPECT_THROW(server.route(Method::Get, "a", handler), std::invalid_argument);
}

TEST_F(Http, AnAddressInUseIsRefusedAtOnce) {
  begin();
  ServerConfig config;
  config.port = port_;
  EXPECT_THROW(Server{config}, ServerError);
  config.address = "nowhere";
  EXPECT_THROW(Server{config}, ServerError);
}

}  // namespace
}  // namespace tacit::gateway
