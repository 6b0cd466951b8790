#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "tests/gateway/fixture.h"

namespace tacit::gateway {
namespace {

using nlohmann::json;

std::size_t threads() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    ++count;
  }
  return count;
}

double resident_mib() {
  std::ifstream file("/proc/self/statm");
  double total = 0;
  double resident = 0;
  file >> total >> resident;
  return resident * 4096.0 / 1048576.0;
}

class Load : public SocketFixture {};

TEST_F(Load, TwoHundredClientsShareTheBytes) {
  begin();
  const ChannelId state = session_->advertise(channel("/state", Keep::Latest));
  std::vector<std::unique_ptr<Socket>> sockets;
  for (std::uint32_t i = 0; i < 200; ++i) {
    sockets.push_back(std::make_unique<Socket>(port_));
    subscribe(*sockets.back(), i, state);
  }
  const double before_mib = resident_mib();
  const std::vector<std::uint8_t> bytes(20'000);
  constexpr std::uint64_t kMessages = 100;  // 400 MB, if each client had its own.
  for (std::uint64_t i = 1; i <= kMessages; ++i) {
    session_->publish(state, i, bytes);
  }
  EXPECT_LT(resident_mib() - before_mib, 100.0);
  for (const auto& socket : sockets) {
    while (number_at(socket->next_binary(1), 5, 8) < kMessages) {
    }
  }
  EXPECT_EQ(server_->counters().websockets_open, 200U);
  sockets.clear();
  EXPECT_TRUE(comes_true([&] { return session_->clients() == 0; }));
}

TEST_F(Load, StoppingLeavesNoThreadAndWaitsForNoClient) {
  const std::size_t before = threads();
  Limits limits;
  limits.stop_s = 0.3;
  begin(limits);
  const ChannelId telemetry = session_->advertise(channel("/telemetry"));
  Socket idle(port_);
  Socket stalled(port_);
  subscribe(stalled, 1, telemetry);
  const auto large = std::make_shared<const std::vector<std::uint8_t>>(1'000'000);
  for (int i = 0; i < 20; ++i) {
    session_->publish(telemetry, 1, large);
  }
  EXPECT_EQ(threads(), before + 1);
  const auto start = std::chrono::steady_clock::now();
  server_.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  EXPECT_EQ(threads(), before);
  session_->publish(telemetry, 1, large);
}

TEST_F(Load, PublishersClientsAndTheEndMayComeInAnyOrder) {
  begin();
  const ChannelId state = session_->advertise(channel("/state", Keep::Latest));
  std::atomic<bool> over = false;
  std::vector<std::thread> publishers;
  for (int i = 0; i < 3; ++i) {
    publishers.emplace_back([&] {
      const auto bytes = std::make_shared<const std::vector<std::uint8_t>>(1000);
      for (std::uint64_t time_ns = 0; !over; ++time_ns) {
        session_->publish(state, time_ns, bytes);
        session_->set_time(time_ns);
        const ChannelId passing = session_->advertise(channel("/passing"));
        session_->unadvertise(passing);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
  }
  for (std::uint32_t i = 0; i < 20; ++i) {
    Socket socket(port_);
    socket.say({{"op", "subscribe"}, {"subscriptions", {{{"id", i}, {"channelId", state}}}}});
    EXPECT_EQ(number_at(socket.next_binary(1), 1, 4), i);
    if (i % 2 == 0) {
      socket.vanish();
    }
  }
  Socket last(port_);
  server_.reset();
  over = true;
  for (std::thread& publisher : publishers) {
    publisher.join();
  }
}

/// Bytes by chance, the same in each run.
class Fuzz : public SocketFixture {
 protected:
  std::size_t below(std::size_t end) { return chance_() % end; }

  std::string noise(std::size_t most) {
    std::string bytes(below(most + 1), '\0');
    for (char& byte : bytes) {
      byte = static_cast<char>(below(256));
    }
    return bytes;
  }

  std::string damaged(std::string text) {
    for (std::size_t changes = below(4); changes > 0 && !text.empty(); --changes) {
      const std::size_t at = below(text.size());
      switch (below(3)) {
        case 0:
          text[at] = static_cast<char>(32 + below(95));
          break;
        case 1:
          text.resize(at);
          break;
        default:
          text.insert(at, text.substr(at / 2, at - at / 2));
      }
    }
    return text;
  }

  std::mt19937 chance_{20'241'129};
};

TEST_F(Fuzz, GarbageAndTruncatedRequestsDoNoHarm) {
  Limits limits;
  limits.header_s = limits.body_s = 0.2;
  begin(limits);
  server_->open_session("other", "Other");
  const std::string upgrade =
      "GET /ws/run-1?token=x HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: "
      "Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n";
  const std::string post =
      "POST /a/%20b?c=d HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
      "Transfer-Encoding: chunked\r\n\r\n5\r\n{\"a\":\r\n2\r\n1}\r\n0\r\n\r\n";
  for (int i = 0; i < 300; ++i) {
    const std::string request = damaged(below(2) == 0 ? upgrade : post);
    static_cast<void>(raw(port_, below(8) == 0 ? noise(3000) : request, 0.005));
  }
  EXPECT_EQ(get(port_, "/").status, 200);
  EXPECT_TRUE(comes_true([&] { return server_->counters().connections_open == 0; }));
}

TEST_F(Fuzz, FramesByChanceDoNoHarm) {
  begin();
  const std::string upgrade =
      "GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n";
  for (int i = 0; i < 300; ++i) {
    std::string frames;
    for (std::size_t count = 1 + below(4); count > 0; --count) {
      std::string body = noise(120);
      const std::size_t kind = below(8) == 0 ? below(256) : 0x81U + below(2);
      if (kind == 0x81U) {
        std::transform(body.begin(), body.end(), body.begin(), [](char c) { return c & 0x7f; });
      }
      frames += static_cast<char>(kind);
      frames += static_cast<char>((below(8) == 0 ? 0U : 0x80U) + body.size());
      frames += std::string(4, '\0') + body;
    }
    static_cast<void>(raw(port_, upgrade, frames, 0.01));
  }
  EXPECT_GT(server_->counters().messages_received, 100U);
  EXPECT_EQ(Socket(port_).next("serverInfo").at("sessionId"), "run-1");
  EXPECT_TRUE(comes_true([&] { return session_->clients() == 0; }));
}

TEST_F(Fuzz, DamagedWordsDoNoHarm) {
  Limits limits;
  limits.messages_per_s = 1e6;
  begin(limits);
  const ChannelId id = session_->advertise(channel("/state", Keep::Latest));
  session_->publish(id, 1, bytes_of("state"));
  session_->set_parameters({{"a", "1"}});
  session_->on_parameters(
      [&](const std::vector<Parameter>& wanted) { session_->set_parameters(wanted); });
  const ServiceId service = session_->add_service(
      {"echo", "tacit/Echo", "", ""},
      [](std::string_view request, const ServiceReply& reply) { reply.ok(request); });
  const std::vector<std::string> words{
      R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1},{"id":2,"channelId":1}]})",
      R"({"op":"unsubscribe","subscriptionIds":[1,2]})",
      R"({"op":"getParameters","parameterNames":["a"],"id":"q"})",
      R"({"op":"setParameters","parameters":[{"name":"a","value":[1,{"b":2}],"type":"x"}],"id":"q"})",
      R"({"op":"subscribeParameterUpdates","parameterNames":["a","b"]})",
      R"({"op":"unsubscribeParameterUpdates","parameterNames":[]})",
      R"({"op":"subscribeConnectionGraph"})",
      R"({"op":"unsubscribeConnectionGraph"})",
  };
  Socket socket(port_);
  for (int i = 0; i < 2000; ++i) {
    if (below(4) == 0) {
      socket.say_binary(damaged(service_request(service, 1, R"({"a":[1,2]})")));
    } else {
      socket.say_text(damaged(words[below(words.size())]));
    }
    if (i % 100 == 99) {
      // Answers are read in between; the server need not hold them all.
      socket.say({{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "round"}});
      while (socket.next("parameterValues").value("id", "") != "round") {
      }
    }
  }
  EXPECT_EQ(session_->clients(), 1U);
}

}  // namespace
}  // namespace tacit::gateway
