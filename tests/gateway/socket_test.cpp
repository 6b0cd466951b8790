#include <stdexcept>

#include "tests/gateway/fixture.h"

namespace tacit::gateway {
namespace {

using nlohmann::json;

class SocketTest : public SocketFixture {
 protected:
  SocketTest() { begin(); }
};

class UnderEachName : public SocketTest, public ::testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Protocol, UnderEachName,
                         ::testing::Values("foxglove.sdk.v1", "foxglove.websocket.v1"));

TEST_P(UnderEachName, AClientIsGreetedAndGetsWhatItSubscribesTo) {
  const ChannelId id = session_->advertise(channel("/status"));
  Socket socket(server_->port(), "/ws/run-1", GetParam());
  EXPECT_EQ(socket.protocol(), GetParam());

  const json info = socket.next("serverInfo");
  EXPECT_EQ(info.at("name"), "First run");
  EXPECT_EQ(info.at("sessionId"), "run-1");
  EXPECT_EQ(info.at("supportedEncodings"), json::array({"json"}));
  EXPECT_EQ(info.at("capabilities"), json::array({"time", "services", "parameters",
                                                  "parametersSubscribe", "connectionGraph"}));
  EXPECT_EQ(socket.next("advertise").at("channels"),
            json::array({{{"id", id},
                          {"topic", "/status"},
                          {"encoding", "cdr"},
                          {"schemaName", "tacit/msg/Status"},
                          {"schema", "uint32 tick"},
                          {"schemaEncoding", "ros2msg"}}}));

  subscribe(socket, 7, id);
  session_->publish(id, 123456789012345ULL, bytes_of("hello"));
  const std::string message = socket.next_binary(1);
  EXPECT_EQ(number_at(message, 1, 4), 7U);
  EXPECT_EQ(number_at(message, 5, 8), 123456789012345ULL);
  EXPECT_EQ(message.substr(13), "hello");
}

TEST_F(SocketTest, TheBetterNameIsChosenOfThoseOffered) {
  EXPECT_EQ(Socket(server_->port(), "/ws", "foxglove.websocket.v1, foxglove.sdk.v1").protocol(),
            "foxglove.sdk.v1");
}

TEST_F(SocketTest, WithoutAKnownSubProtocolThereIsNoSocket) {
  EXPECT_THROW(Socket(server_->port(), "/ws", ""), std::runtime_error);
  EXPECT_THROW(Socket(server_->port(), "/ws", "graphql-ws"), std::runtime_error);
  EXPECT_EQ(server_->counters().requests_by_status.at(400), 2U);
}

TEST_F(SocketTest, OnlySubscribersGetMessages) {
  const ChannelId one = session_->advertise(channel("/one"));
  const ChannelId other = session_->advertise(channel("/other"));
  Socket socket(server_->port());
  subscribe(socket, 1, one);
  session_->publish(other, 1, bytes_of("other"));
  session_->publish(one, 2, bytes_of("one"));
  EXPECT_EQ(socket.next_binary(1).substr(13), "one");
  socket.say({{"op", "unsubscribe"}, {"subscriptionIds", {1}}});
  ASSERT_TRUE(comes_true([&] { return session_->subscribers(one) == 0; }));
  session_->publish(one, 3, bytes_of("one"));
  EXPECT_TRUE(socket.is_quiet(0.2));
}

TEST_F(SocketTest, ALateSubscriberGetsTheLatestOfAStateAndNothingOfHappenings) {
  const ChannelId state = session_->advertise(channel("/state", Keep::Latest));
  const ChannelId happenings = session_->advertise(channel("/events"));
  session_->publish(state, 1, bytes_of("old"));
  session_->publish(state, 2, bytes_of("new"));
  session_->publish(happenings, 3, bytes_of("event"));
  Socket socket(server_->port());
  subscribe(socket, 1, happenings);
  subscribe(socket, 2, state);
  const std::string message = socket.next_binary(1);
  EXPECT_EQ(number_at(message, 1, 4), 2U);
  EXPECT_EQ(number_at(message, 5, 8), 2U);
  EXPECT_EQ(message.substr(13), "new");
  EXPECT_TRUE(socket.is_quiet(0.2));
}

TEST_F(SocketTest, ChannelsComeAndGo) {
  Socket socket(server_->port());
  EXPECT_EQ(socket.next("serverInfo").at("sessionId"), "run-1");
  const ChannelId id = session_->advertise(channel("/status"));
  EXPECT_EQ(socket.next("advertise").at("channels").at(0).at("id"), id);
  subscribe(socket, 1, id);
  session_->unadvertise(id);
  EXPECT_EQ(socket.next("unadvertise").at("channelIds"), json::array({id}));
  session_->publish(id, 1, bytes_of("late"));
  EXPECT_NE(session_->advertise(channel("/status")), id);
  EXPECT_EQ(socket.next("advertise").at("channels").size(), 1U);
}

TEST_F(SocketTest, TheTimeIsTold) {
  session_->set_time(5'000'000'000'000ULL);
  Socket socket(server_->port());
  EXPECT_EQ(number_at(socket.next_binary(2), 1, 8), 5'000'000'000'000ULL);
  session_->set_time(6);
  EXPECT_EQ(number_at(socket.next_binary(2), 1, 8), 6U);
}

TEST_F(SocketTest, AServiceAnswersFromAnotherThread) {
  std::thread answering;
  const ServiceId id = session_->add_service(
      {"speed", "tacit/Speed", R"({"type":"object"})", R"({"type":"object"})"},
      [&](std::string_view request, const ServiceReply& reply) {
        answering = std::thread(
            [reply, text = std::string(request)] { reply.ok("{\"got\":" + text + "}"); });
      });
  Socket socket(server_->port());
  const json service = socket.next("advertiseServices").at("services").at(0);
  EXPECT_EQ(service.at("id"), id);
  EXPECT_EQ(service.at("name"), "speed");
  EXPECT_EQ(service.at("request").at("schemaEncoding"), "jsonschema");
  socket.say_binary(service_request(id, 42, R"({"factor":2})"));
  const std::string response = socket.next_binary(3);
  EXPECT_EQ(number_at(response, 1, 4), id);
  EXPECT_EQ(number_at(response, 5, 4), 42U);
  EXPECT_EQ(response.substr(9), little(4, 4) + R"(json{"got":{"factor":2}})");
  answering.join();
}

TEST_F(SocketTest, AServiceThatFailsSaysWhy) {
  const auto failing = [&](const std::string& name, ServiceHandler handler) {
    return session_->add_service({name, "tacit/Stop", "", ""}, std::move(handler));
  };
  const ServiceId fails = failing("fails", [](std::string_view, const ServiceReply& reply) {
    reply.fail("the run is over");
    reply.ok("{}");
  });
  const ServiceId throws = failing(
      "throws", [](std::string_view, const ServiceReply&) { throw std::runtime_error("thrown"); });
  const ServiceId forgets = failing("forgets", [](std::string_view, const ServiceReply&) {});
  Socket socket(server_->port());
  const auto failure = [&](ServiceId service, const std::string& request) {
    socket.say_binary(service_request(service, 5, request));
    const json answer = socket.next("serviceCallFailure");
    EXPECT_EQ(answer.at("serviceId"), service);
    EXPECT_EQ(answer.at("callId"), 5);
    return answer.at("message").get<std::string>();
  };
  EXPECT_EQ(failure(fails, "{}"), "the run is over");
  EXPECT_EQ(failure(throws, ""), "thrown");
  EXPECT_EQ(failure(forgets, "{}"), "the call was dropped without an answer");
  EXPECT_EQ(failure(999, "{}"), "there is no such service");
  EXPECT_EQ(failure(fails, "{"), "the request is no JSON");
  EXPECT_EQ(failure(fails, std::string(100000, '[')), "the request is no JSON");
  session_->remove_service(fails);
  EXPECT_EQ(socket.next("unadvertiseServices").at("serviceIds"), json::array({fails}));
  EXPECT_EQ(failure(fails, "{}"), "there is no such service");
}

TEST_F(SocketTest, ParametersAreReadSetAndFollowed) {
  session_->set_parameters({{"alpha", "0.5", "float64"}, {"name", "\"guard\""}});
  session_->on_parameters([&](const std::vector<Parameter>& wanted) {
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted[0].value, "0.7");
    session_->set_parameters({{wanted[0].name, "0.6", "float64"}});
  });
  Socket socket(server_->port());
  socket.say({{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "all"}});
  const json all = socket.next("parameterValues");
  EXPECT_EQ(all.at("id"), "all");
  EXPECT_EQ(all.at("parameters"), json::parse(R"([{"name":"alpha","value":0.5,"type":"float64"},
                            {"name":"name","value":"guard"}])"));
  socket.say({{"op", "subscribeParameterUpdates"}, {"parameterNames", {"alpha"}}});
  socket.say({{"op", "setParameters"},
              {"parameters", {{{"name", "alpha"}, {"value", 0.7}}}},
              {"id", "mine"}});
  const json update = socket.next("parameterValues");
  EXPECT_FALSE(update.contains("id"));
  EXPECT_EQ(update.at("parameters").at(0).at("value"), 0.6);
  const json answer = socket.next("parameterValues");
  EXPECT_EQ(answer.at("id"), "mine");
  EXPECT_EQ(answer.at("parameters").at(0).at("value"), 0.6);
  socket.say({{"op", "unsubscribeParameterUpdates"}, {"parameterNames", {"alpha"}}});
  socket.say({{"op", "getParameters"}, {"parameterNames", {"nothing"}}, {"id", "none"}});
  EXPECT_EQ(socket.next("parameterValues").at("parameters"), json::array());
  session_->set_parameters({{"alpha", "1"}});
  EXPECT_TRUE(socket.is_quiet(0.2));
  EXPECT_THROW(session_->set_parameters({{"alpha", "{"}}), std::invalid_argument);
}

TEST_F(SocketTest, TheGraphIsToldToThoseWhoFollowItAndThenItsChanges) {
  session_->set_connection_graph(
      {{{"/percept", {"world"}}}, {{"/percept", {"robot_1"}}}, {{"stop", {"console"}}}});
  Socket socket(server_->port());
  socket.say({{"op", "subscribeConnectionGraph"}});
  json update = socket.next("connectionGraphUpdate");
  EXPECT_EQ(update.at("publishedTopics"),
            json::parse(R"([{"name":"/percept","publisherIds":["world"]}])"));
  EXPECT_EQ(update.at("subscribedTopics"),
            json::parse(R"([{"name":"/percept","subscriberIds":["robot_1"]}])"));
  EXPECT_EQ(update.at("advertisedServices"),
            json::parse(R"([{"name":"stop","providerIds":["console"]}])"));
  session_->set_connection_graph({{{"/events", {"world"}}}, {{"/percept", {"robot_1"}}}, {}});
  update = socket.next("connectionGraphUpdate");
  EXPECT_EQ(update.at("publishedTopics"),
            json::parse(R"([{"name":"/events","publisherIds":["world"]},
                            {"name":"/percept","publisherIds":[]}])"));
  EXPECT_EQ(update.at("subscribedTopics"), json::array());
  EXPECT_EQ(update.at("removedTopics"), json::array());
  EXPECT_EQ(update.at("removedServices"), json::array({"stop"}));
}

TEST_F(SocketTest, AStatusWithAnIdStaysUntilItIsRemoved) {
  session_->status(StatusLevel::Info, "nobody is here");
  session_->status(StatusLevel::Warning, "an agent is lost", "agent");
  Socket socket(server_->port());
  const json status = socket.next("status");
  EXPECT_EQ(status.at("level"), 1);
  EXPECT_EQ(status.at("message"), "an agent is lost");
  EXPECT_EQ(status.at("id"), "agent");
  session_->remove_status("agent");
  EXPECT_EQ(socket.next("removeStatus").at("statusIds"), json::array({"agent"}));
}

TEST_F(SocketTest, WhatIsNotUnderstoodIsAnsweredWithAStatus) {
  Socket socket(server_->port());
  const auto complaint = [&](const std::string& text) {
    socket.say_text(text);
    return socket.next("status").at("message").get<std::string>();
  };
  EXPECT_EQ(complaint("{"), "the message is no JSON object");
  EXPECT_EQ(complaint("[]"), "the message is no JSON object");
  EXPECT_EQ(complaint(R"({"op":"advertise"})"), "not understood here: op \"advertise\"");
  EXPECT_EQ(complaint(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":99}]})"),
            "there is no channel 99");
  EXPECT_EQ(complaint(R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":4294967296}]})"),
            "subscribe: a subscription has an id and a channelId");
  EXPECT_EQ(complaint(R"({"op":"unsubscribe","subscriptionIds":[3]})"),
            "there is no subscription 3");
  EXPECT_EQ(complaint(R"({"op":"setParameters","parameters":[{"name":"a","value":1}]})"),
            "parameters cannot be set here");
  EXPECT_EQ(complaint(R"({"op":)" + std::string(100000, '[')), "the message nests too deep");
  socket.say_binary("\x02short");
  EXPECT_EQ(socket.next("status").at("message"), "a service call is cut short");
}

TEST_F(SocketTest, AChannelIsSubscribedToOnce) {
  const ChannelId id = session_->advertise(channel("/status"));
  Socket socket(server_->port());
  subscribe(socket, 1, id);
  socket.say({{"op", "subscribe"}, {"subscriptions", {{{"id", 2}, {"channelId", id}}}}});
  EXPECT_NE(socket.next("status").at("message").get<std::string>().find("already"),
            std::string::npos);
  EXPECT_EQ(session_->subscribers(id), 1U);
}

TEST_F(SocketTest, TheNewestSessionAnswersWhereNoneIsNamed) {
  const auto id_at = [&](const std::string& target) {
    return Socket(server_->port(), target).next("serverInfo").at("sessionId").get<std::string>();
  };
  EXPECT_EQ(id_at("/"), "run-1");
  server_->open_session("run-2", "Second run");
  EXPECT_EQ(id_at("/ws"), "run-2");
  EXPECT_EQ(id_at("/ws/run-1"), "run-1");
  server_->mark_newest("run-1");
  EXPECT_EQ(id_at("/ws"), "run-1");
  server_->close_session("run-1");
  EXPECT_EQ(id_at("/"), "run-2");
  EXPECT_THROW(id_at("/ws/run-1"), std::runtime_error);
  EXPECT_THROW(id_at("/elsewhere"), std::runtime_error);
  EXPECT_THROW(server_->open_session("run-2", "again"), std::invalid_argument);
  EXPECT_THROW(server_->open_session("a/b", "slash"), std::invalid_argument);
}

TEST_F(SocketTest, AClosedSessionSendsItsClientsAwayAndIsDeafAfterwards) {
  Socket socket(server_->port());
  ASSERT_TRUE(comes_true([&] { return session_->clients() == 1; }));
  server_->close_session("run-1");
  EXPECT_EQ(socket.close_code(), 1001);
  const ChannelId id = session_->advertise(channel("/status"));
  session_->publish(id, 1, bytes_of("nobody"));
  session_->set_time(1);
  session_->status(StatusLevel::Info, "nobody", "id");
  ASSERT_TRUE(comes_true([&] { return session_->clients() == 0; }));
}

TEST_F(SocketTest, AClientThatGoesIsForgotten) {
  const ChannelId id = session_->advertise(channel("/status"));
  {
    Socket socket(server_->port());
    subscribe(socket, 1, id);
    socket.vanish();
  }
  ASSERT_TRUE(comes_true([&] { return session_->clients() == 0; }));
  EXPECT_EQ(session_->subscribers(id), 0U);
  ASSERT_TRUE(comes_true([&] { return server_->counters().connections_open == 0; }));
  EXPECT_EQ(server_->counters().websockets_open, 0U);
  EXPECT_EQ(server_->counters().websockets_total, 1U);
}

TEST_F(SocketTest, StoppingSaysGoodbyeToClients) {
  Socket socket(server_->port());
  Socket other(server_->port());
  ASSERT_TRUE(comes_true([&] { return session_->clients() == 2; }));
  std::thread stopping([&] { server_->stop(); });
  EXPECT_EQ(socket.close_code(), 1001);
  EXPECT_EQ(other.close_code(), 1001);
  stopping.join();
  session_->status(StatusLevel::Info, "nobody is here");
}

TEST_F(SocketTest, MessagesAreCompressedOnlyWhereThatIsWanted) {
  const std::string upgrade =
      "GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Extensions: permessage-deflate\r\n"
      "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n";
  const std::string goodbye("\x88\x80\0\0\0\0", 6);
  ServerConfig config;
  config.compress = true;
  Server compressing(config);
  compressing.open_session("run", "Run");
  compressing.start();
  const auto plain = raw(port_, upgrade, goodbye, 5.0);
  const auto compressed = raw(compressing.port(), upgrade, goodbye, 5.0);
  ASSERT_TRUE(plain && compressed);
  EXPECT_EQ(plain->find("permessage-deflate"), std::string::npos);
  EXPECT_NE(plain->find("serverInfo"), std::string::npos);
  EXPECT_NE(compressed->find("permessage-deflate"), std::string::npos);
  EXPECT_EQ(compressed->find("serverInfo"), std::string::npos);
}

TEST_F(SocketTest, APlainRequestToASocketIs426) {
  EXPECT_EQ(get(server_->port(), "/ws/run-1").status, 426);
}

}  // namespace
}  // namespace tacit::gateway
