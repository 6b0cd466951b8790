#include <mutex>

#include "tests/gateway/fixture.h"

namespace tacit::gateway {
namespace {

using nlohmann::json;
using Seconds = std::chrono::duration<double>;

class LimitsTest : public SocketFixture {
 protected:
  ServiceId echo() {
    return session_->add_service(
        {"echo", "tacit/Echo", "", ""},
        [](std::string_view request, const ServiceReply& reply) { reply.ok(request); });
  }
};

TEST_F(LimitsTest, WhoDoesNotReadLosesTelemetryButNoAnswers) {
  Limits limits;
  limits.queue_bytes = 1U << 20U;
  limits.stalled_s = 60.0;
  begin(limits);
  const ChannelId telemetry = session_->advertise(channel("/telemetry", Keep::Latest));
  const ServiceId service = echo();
  Socket slow(port_);
  subscribe(slow, 1, telemetry);
  const std::vector<std::uint8_t> large(100'000);
  std::uint64_t time_ns = 0;
  while (server_->counters().messages_dropped < 100) {
    session_->publish(telemetry, ++time_ns, large);
    ASSERT_LT(time_ns, 5000U);
  }
  slow.say_binary(service_request(service, 9, "{}"));
  const ChannelId later = session_->advertise(channel("/later"));

  bool answered = false;
  bool advertised = false;
  std::uint64_t seen_ns = 0;
  while (seen_ns < time_ns || !answered || !advertised) {
    const Socket::Message message = slow.next();
    if (message.binary && message.bytes[0] == 1) {
      EXPECT_GT(number_at(message.bytes, 5, 8), seen_ns);
      seen_ns = number_at(message.bytes, 5, 8);
    }
    answered = answered || (message.binary && message.bytes[0] == 3);
    advertised = advertised || (!message.binary && message.json().at("op") == "advertise" &&
                                message.json().at("channels").at(0).at("id") == later);
  }
  EXPECT_EQ(seen_ns, time_ns);
}

TEST_F(LimitsTest, WhoDoesNotReadHoldsNobodyUp) {
  begin();
  const ChannelId telemetry = session_->advertise(channel("/telemetry"));
  Socket slow(port_);
  Socket quick(port_);
  subscribe(slow, 1, telemetry);
  subscribe(quick, 1, telemetry);
  const auto large = std::make_shared<const std::vector<std::uint8_t>>(100'000);
  for (std::uint64_t time_ns = 1; time_ns <= 300; ++time_ns) {
    session_->publish(telemetry, time_ns, large);
    EXPECT_EQ(number_at(quick.next_binary(1), 5, 8), time_ns);
  }
}

TEST_F(LimitsTest, WhoDoesNotReadAtAllIsClosedAfterAWhile) {
  Limits limits;
  limits.stalled_s = 0.3;
  begin(limits);
  const ChannelId telemetry = session_->advertise(channel("/telemetry"));
  Socket slow(port_);
  subscribe(slow, 1, telemetry);
  const auto large = std::make_shared<const std::vector<std::uint8_t>>(100'000);
  for (int i = 0; i < 200; ++i) {
    session_->publish(telemetry, 1, large);
  }
  EXPECT_TRUE(comes_true([&] { return session_->clients() == 0; }));
  EXPECT_EQ(server_->counters().websockets_stalled, 1U);
}

TEST_F(LimitsTest, WhoLetsTooManyAnswersWaitIsClosed) {
  Limits limits;
  limits.control_bytes = 1U << 20U;
  begin(limits);
  Socket slow(port_);
  ASSERT_TRUE(comes_true([&] { return session_->clients() == 1; }));
  const std::string text(100'000, 'x');
  for (int i = 0; i < 300; ++i) {
    session_->status(StatusLevel::Info, text);
  }
  EXPECT_TRUE(comes_true([&] { return session_->clients() == 0; }));
  EXPECT_EQ(server_->counters().websockets_stalled, 1U);
}

TEST_F(LimitsTest, AMessageTooLargeClosesTheSocket) {
  Limits limits;
  limits.message_bytes = 1000;
  begin(limits);
  Socket socket(port_);
  socket.say_text(std::string(1001, ' '));
  EXPECT_EQ(socket.close_code(), 1009);
}

TEST_F(LimitsTest, WhoSaysTooMuchIsHeardMoreSlowly) {
  Limits limits;
  limits.messages_per_s = 100.0;
  begin(limits);
  const ServiceId service = echo();
  Socket socket(port_);
  const auto start = std::chrono::steady_clock::now();
  for (std::uint32_t call = 0; call < 160; ++call) {
    socket.say_binary(service_request(service, call, "{}"));
  }
  for (std::uint32_t call = 0; call < 160; ++call) {
    EXPECT_EQ(number_at(socket.next_binary(3), 5, 4), call);
  }
  EXPECT_GT(Seconds(std::chrono::steady_clock::now() - start).count(), 0.5);
}

TEST_F(LimitsTest, CallsWithoutAnAnswerAreBounded) {
  Limits limits;
  limits.calls = 2;
  begin(limits);
  std::mutex mutex;
  std::vector<ServiceReply> replies;
  const ServiceId service = session_->add_service({"slow", "tacit/Slow", "", ""},
                                                  [&](std::string_view, const ServiceReply& reply) {
                                                    const std::scoped_lock lock(mutex);
                                                    replies.push_back(reply);
                                                  });
  Socket socket(port_);
  for (const std::uint32_t call : {1U, 2U, 3U}) {
    socket.say_binary(service_request(service, call, "{}"));
  }
  EXPECT_EQ(socket.next("serviceCallFailure").at("callId"), 3);
  const std::scoped_lock lock(mutex);
  replies.at(0).ok("{}");
  EXPECT_EQ(number_at(socket.next_binary(3), 5, 4), 1U);
  server_.reset();
  replies.at(1).ok("{}");
}

TEST_F(LimitsTest, WhoAnswersNoPingIsClosedAndWhoDoesStays) {
  Limits limits;
  limits.silence_s = 0.4;
  begin(limits);
  const Socket silent(port_);
  Socket alive(port_);
  while (alive.next("serverInfo").empty()) {
  }
  EXPECT_TRUE(alive.is_quiet(2.0));
  EXPECT_EQ(session_->clients(), 1U);
}

}  // namespace
}  // namespace tacit::gateway
