// A gateway with one session for clients of others to try; ends when its input does.

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <iostream>
#include <thread>

#include "console/gateway/server.h"

namespace {

using namespace tacit::gateway;

/// A CDR message with one number.
std::vector<std::uint8_t> cdr(std::uint32_t tick) {
  std::vector<std::uint8_t> bytes{0, 1, 0, 0, 0, 0, 0, 0};
  std::memcpy(bytes.data() + 4, &tick, sizeof tick);
  return bytes;
}

void fill(Session& session) {
  session.add_service(
      {"echo", "tacit/Echo", R"({"type":"object"})", R"({"type":"object"})"},
      [](std::string_view request, const ServiceReply& reply) { reply.ok(request); });
  session.set_parameters({{"alpha", "0.5", "float64"}});
  session.on_parameters(
      [&session](const std::vector<Parameter>& wanted) { session.set_parameters(wanted); });
  session.set_connection_graph({{{"/tick", {"world"}}}, {}, {}});
  session.status(StatusLevel::Warning, "an agent is lost", "agent");
}

void publish_until(Session& session, const std::atomic<bool>& over) {
  constexpr std::uint64_t kTick_ns = 50'000'000;
  const ChannelId channel =
      session.advertise({"/tick", "cdr", "tacit/msg/Tick", "uint32 tick", "ros2msg", Keep::Latest});
  for (std::uint32_t tick = 1; !over; ++tick) {
    session.set_time(tick * kTick_ns);
    session.publish(channel, tick * kTick_ns, cdr(tick));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

int main() {
  Server server({});
  const auto session = server.open_session("run-1", "Interop");
  fill(*session);
  server.start();
  std::atomic<bool> over = false;
  std::thread publisher([&] { publish_until(*session, over); });
  std::cout << server.port() << std::endl;
  for (char byte = 0; ::read(STDIN_FILENO, &byte, 1) > 0;) {
  }
  over = true;
  publisher.join();
  server.stop();
  server.close_session("run-1");
}
