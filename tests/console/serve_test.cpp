// The console as programs and browsers meet it: its REST interface and sockets, with real runs.

#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "idl/bus/cdr.h"
#include "idl/types/roster.h"
#include "idl/types/world_view.h"
#include "tests/gateway/client.h"
#include "tests/process/programs.h"

namespace tacit {
namespace {

using gateway::Ask;
using gateway::Reply;
using gateway::Socket;
using nlohmann::json;
using namespace std::chrono_literals;

/// Processes with that word in their command line.
int count_of_processes(const std::string& word) {
  int count = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    std::ifstream in(entry.path() / "cmdline", std::ios::binary);
    const std::string words{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (words.find(word) != std::string::npos) ++count;
  }
  return count;
}

/// A console of its own.
class Serve : public testing::Test {
 protected:
  Serve() { begin(); }
  ~Serve() override {
    end_runs();
    console_->send(SIGINT);
    (void)console_->finish(20s);
  }

  /// Runs live on without their console, also those of a test that failed.
  void end_runs() const {
    (void)becomes_true(
        [this] {
          const json runs = json::parse(gateway::get(port_, "/api/runs").body, nullptr, false);
          bool live = false;
          for (const json& run : runs.is_array() ? runs : json::array()) {
            if (run.value("state", "") != "live") continue;
            live = true;
            (void)gateway::ask(port_, {"DELETE", "/api/runs/" + run.value("id", ""), {}, {}});
          }
          return !live;
        },
        20s);
  }

  void begin() {
    console_ = std::make_unique<Running>(std::vector<std::string>{
        program("console"), "serve", "--port", "0", "--runs", (scratch_ / "runs").string(),
        "--cases", (scratch_ / "cases.db").string()});
    const auto address = [this] { return text_after("http://127.0.0.1:", console_->printed()); };
    ASSERT_TRUE(becomes_true([&] { return !address().empty(); }));
    port_ = static_cast<std::uint16_t>(std::stoi(address()));
  }

  static std::string text_after(const std::string& begin, const std::string& text) {
    const std::size_t at = text.find(begin);
    if (at == std::string::npos || text.find('/', at + begin.size()) == std::string::npos)
      return {};
    return text.substr(at + begin.size());
  }

  [[nodiscard]] json got(const std::string& target, int status = 200) const {
    const Reply reply = gateway::get(port_, target);
    EXPECT_EQ(reply.status, status) << target << ": " << reply.body;
    return json::parse(reply.body, nullptr, false);
  }
  [[nodiscard]] json asked(const std::string& method, const std::string& target, const json& body,
                           int status) const {
    const Reply reply =
        gateway::ask(port_, {method, target, {{"content-type", "application/json"}}, body.dump()});
    EXPECT_EQ(reply.status, status) << method << ' ' << target << ": " << reply.body;
    return json::parse(reply.body, nullptr, false);
  }

  /// The id of a run that was begun.
  [[nodiscard]] std::string begun(const json& wish) const {
    return asked("POST", "/api/runs", wish, 201).value("id", "");
  }
  [[nodiscard]] std::string state(const std::string& run) const {
    return got("/api/runs/" + run).value("state", "");
  }

  static json office_request(int robots) {
    return {{"tasks", {{{"task", "biohazard"}, {"x", 20}, {"y", 22}}}}, {"robots", robots}};
  }

  Scratch scratch_;
  std::unique_ptr<Running> console_;
  std::uint16_t port_ = 0;
};

/// The ids of channels and services by name, as a client is told them.
struct Told {
  std::map<std::string, std::uint32_t> channels;
  std::map<std::string, std::uint32_t> services;
};

Told told(Socket& socket, const std::string& last_channel) {
  Told all;
  while (!all.channels.contains(last_channel) || !all.services.contains("let_go")) {
    const Socket::Message message = socket.next();
    if (message.binary) continue;
    const json said = message.json();
    for (const json& one : said.value("channels", json::array()))
      all.channels[one["topic"]] = one["id"];
    for (const json& one : said.value("services", json::array()))
      all.services[one["name"]] = one["id"];
  }
  return all;
}

/// The next word on a channel; `subscription` is 7.
template <class Word>
Word next_word(Socket& socket) {
  for (;;) {
    const std::string message = socket.next_binary(1);
    if (gateway::number_at(message, 1, 4) != 7) continue;
    Word word;
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(message.data()) + 13,
                          message.size() - 13);
    EXPECT_FALSE(from_cdr(bytes, word));
    return word;
  }
}

/// The socket of a run that may only just be found.
std::unique_ptr<Socket> joined(std::uint16_t port, const std::string& target) {
  std::unique_ptr<Socket> socket;
  EXPECT_TRUE(becomes_true([&] {
    try {
      socket = std::make_unique<Socket>(port, target);
    } catch (const std::exception&) {
      return false;
    }
    return true;
  }));
  return socket;
}

void subscribe(Socket& socket, std::uint32_t channel) {
  socket.say({{"op", "subscribe"}, {"subscriptions", {{{"id", 7}, {"channelId", channel}}}}});
}

/// Calls until the run is in that phase.
bool gets_into(Socket& socket, RunPhase phase) {
  for (int i = 0; i < 100; ++i) {
    if (next_word<RunStatus>(socket).phase == phase) return true;
  }
  return false;
}

TEST_F(Serve, TellsWhatThereIs) {
  EXPECT_EQ(got("/api/health")["status"], "ok");
  EXPECT_TRUE(got("/api/version")["version"].is_string());
  EXPECT_EQ(got("/api/ready")["status"], "ready");
  EXPECT_EQ(got("/api/runs"), json::array());
  EXPECT_GE(got("/api/maps").size(), 5U);
  EXPECT_GE(got("/api/missions").size(), 8U);
  EXPECT_GE(got("/api/scenarios").size(), 2U);
  const json office = got("/api/maps/office");
  EXPECT_EQ(office["rooms"].size(), 7U);
  EXPECT_GT(office["walls"].size(), 10U);
  const Reply metrics = gateway::get(port_, "/metrics");
  EXPECT_NE(metrics.body.find("# TYPE tacit_runs_live gauge"), std::string::npos);
}

TEST_F(Serve, ShowsARunThatGoesOnAndTakesTheOperatorsWord) {
  const std::string run = begun({{"scenario", "guard"}, {"robots", 3}, {"speed", 5}});
  ASSERT_FALSE(run.empty());
  const std::unique_ptr<Socket> joined_socket = joined(port_, "/ws/" + run);
  ASSERT_NE(joined_socket, nullptr);
  Socket& socket = *joined_socket;
  const Told known = told(socket, "/tacit/robot_3/telemetry");
  subscribe(socket, known.channels.at("/tacit/status"));
  EXPECT_TRUE(gets_into(socket, RunPhase::Running));
  socket.say_binary(gateway::service_request(known.services.at("pause"), 1, "{}"));
  EXPECT_TRUE(gets_into(socket, RunPhase::Paused));
  // A tick that was under way is brought to its end.
  (void)next_word<RunStatus>(socket);
  const Tick before = next_word<RunStatus>(socket).tick;
  socket.say_binary(gateway::service_request(known.services.at("step"), 2, R"({"ticks":5})"));
  bool stepped = false;
  for (int i = 0; i < 100 && !stepped; ++i) {
    stepped = next_word<RunStatus>(socket).tick == before + 5;
  }
  EXPECT_TRUE(stepped);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(next_word<RunStatus>(socket).tick, before + 5);
  socket.say_binary(gateway::service_request(known.services.at("speed"), 3, R"({"factor":-1})"));
  EXPECT_NE(socket.next("serviceCallFailure")["message"].get<std::string>().find("wanted"),
            std::string::npos);
  socket.say(
      {{"op", "subscribe"},
       {"subscriptions", {{{"id", 8}, {"channelId", known.channels.at("/tacit/world_view")}}}}});
  EXPECT_EQ(state(run), "live");
  (void)asked("DELETE", "/api/runs/" + run, json::object(), 200);
  EXPECT_TRUE(becomes_true([&] { return state(run) == "stopped"; }));
  EXPECT_EQ(got("/api/runs/" + run + "/scene")["target"]["x"], 100.0);
}

TEST_F(Serve, PlaysARecordingThatCanBeMovedInTime) {
  const std::string run =
      begun({{"scenario", "guard"}, {"robots", 2}, {"speed", 20}, {"duration", 60}});
  ASSERT_TRUE(becomes_true([&] { return state(run) == "done"; }));
  EXPECT_EQ(got("/api/runs")[0]["recording"], true);
  const std::string id = asked("POST", "/api/replays", {{"run", run}}, 201).value("id", "");
  Socket socket(port_, "/ws/" + id);
  std::map<std::string, std::uint32_t> channels;
  std::map<std::string, std::uint32_t> services;
  while (!channels.contains("/tacit/world_view") || !services.contains("seek")) {
    const Socket::Message message = socket.next();
    if (message.binary) continue;
    const json said = message.json();
    for (const json& one : said.value("channels", json::array()))
      channels[one["topic"]] = one["id"];
    for (const json& one : said.value("services", json::array())) services[one["name"]] = one["id"];
  }
  subscribe(socket, channels.at("/tacit/world_view"));
  EXPECT_LT(next_word<WorldView>(socket).time_s, 2.0);
  socket.say_binary(gateway::service_request(services.at("seek"), 1, R"({"time_s":30})"));
  double time_s = 0.0;
  for (int i = 0; i < 10 && time_s < 28.0; ++i) time_s = next_word<WorldView>(socket).time_s;
  EXPECT_NEAR(time_s, 30.0, 1.5);
  socket.say_binary(gateway::service_request(services.at("speed"), 2, R"({"factor":10})"));
  socket.say_binary(gateway::service_request(services.at("resume"), 3, "{}"));
  for (int i = 0; i < 200 && time_s < 32.0; ++i) time_s = next_word<WorldView>(socket).time_s;
  EXPECT_GE(time_s, 32.0);
  socket.say_binary(gateway::service_request(services.at("seek"), 4, R"({"time_s":-1})"));
  EXPECT_NE(socket.next("serviceCallFailure")["message"].get<std::string>().find("wanted 0"),
            std::string::npos);
  (void)asked("DELETE", "/api/replays/" + run, json::object(), 200);
  EXPECT_EQ(socket.close_code(), 1001);
  (void)asked("POST", "/api/replays", {{"run", "nothing"}}, 422);
}

TEST_F(Serve, FindsRunsThatOthersStarted) {
  Running run(tacit_words({"run", "guard", "--robots", "2", "--speed", "5", "--quiet", "--out",
                           (scratch_ / "runs" / "mine").string(), "--store",
                           (scratch_ / "runs.db").string()}));
  ASSERT_NE(joined(port_, "/ws/mine"), nullptr);
  Socket newest(port_, "/ws");
  EXPECT_EQ(newest.next("serverInfo")["sessionId"], "mine");
  run.send(SIGINT);
  (void)run.finish();
}

TEST_F(Serve, PlansRunsDebriefsAndLearns) {
  const json plan =
      asked("POST", "/api/plans", {{"map_name", "office"}, {"request", office_request(1)}},
            200)["plans"][0];
  const std::string run =
      begun({{"mission", plan["mission"]}, {"map_name", "office"}, {"speed", "max"}});
  ASSERT_TRUE(becomes_true([&] { return state(run) == "done"; }));
  const json result = got("/api/runs/" + run);
  EXPECT_EQ(result["score"]["done"], result["score"]["wanted"]) << result.dump(2);
  EXPECT_GE(result["checklist"].size(), 5U);
  json cases = json::array();
  for (const json& used : plan["cases"]) cases.push_back(used["id"]);
  EXPECT_EQ(
      asked("POST", "/api/outcomes",
            {{"cases", cases}, {"score", 1.0}, {"failures", json::array()}, {"map", "office"}},
            200)["text"],
      "Took in how it went.");
  EXPECT_TRUE(
      asked("POST", "/api/cases",
            {{"mission", plan["mission"]}, {"title", "Mine"}, {"request", office_request(1)}},
            200)["text"]
          .is_string());
  const json again =
      asked("POST", "/api/plans", {{"map_name", "office"}, {"request", office_request(1)}},
            200)["plans"][0];
  EXPECT_EQ(again["cases"][0]["record"], "1 of 1 outcomes good");
}

TEST_F(Serve, PreviewsInTheBackgroundAndCancels) {
  const json plan =
      asked("POST", "/api/plans", {{"map_name", "office"}, {"request", office_request(1)}},
            200)["plans"][0];
  const auto preview = [&](int flights) {
    return asked("POST", "/api/previews",
                 {{"mission", plan["mission"]}, {"map_name", "office"}, {"flights", flights}}, 202)
        .value("id", "");
  };
  const auto state_of = [&](const std::string& id) { return got("/api/previews/" + id); };
  const std::string few = preview(3);
  ASSERT_TRUE(becomes_true([&] { return state_of(few)["state"] != "running"; }));
  EXPECT_EQ(state_of(few)["state"], "done");
  EXPECT_EQ(state_of(few)["success"]["share"], 1.0);
  const std::string many = preview(1000);
  (void)asked("DELETE", "/api/previews/" + many, json::object(), 200);
  ASSERT_TRUE(becomes_true([&] { return state_of(many)["state"] != "running"; }));
  EXPECT_EQ(state_of(many)["state"], "cancelled");
}

TEST_F(Serve, SaysWhatIsWrongAndGoesOn) {
  const auto error = [&](const std::string& target, const json& body, int status = 422) {
    return asked("POST", target, body, status).value("error", "");
  };
  EXPECT_NE(error("/api/runs", json::object()).find("wanted one"), std::string::npos);
  EXPECT_NE(error("/api/runs", {{"scenario", "gard"}}).find("did you mean"), std::string::npos);
  EXPECT_NE(error("/api/runs", {{"scenario", "guard"}, {"robots", 0}}).find("robots"),
            std::string::npos);
  EXPECT_NE(error("/api/runs", {{"mission", "nonsense"}, {"map_name", "office"}}).find("found"),
            std::string::npos);
  EXPECT_NE(error("/api/runs", {{"scenario", "guard"}, {"rboots", 2}}).find("did you mean"),
            std::string::npos);
  EXPECT_NE(error("/api/plans", json::object()).find("map"), std::string::npos);
  EXPECT_NE(
      error("/api/plans", {{"map_name", "office"}, {"request", {{"tasks", {{{"task", "tea"}}}}}}})
          .find("tea"),
      std::string::npos);
  EXPECT_NE(error("/api/plans", {{"map", "no map"}, {"request", office_request(1)}}).size(), 0U);
  EXPECT_NE(error("/api/outcomes", {{"cases", {1}}, {"score", 7}}).find("wanted 0 to 1"),
            std::string::npos);
  EXPECT_NE(error("/api/previews", {{"mission", "m"}, {"map_name", "office"}, {"flights", 0}})
                .find("wanted 1 to 1000"),
            std::string::npos);
  (void)got("/api/runs/nothing", 404);
  (void)got("/api/runs/..%2f..%2fetc", 404);
  (void)got("/api/previews/99", 404);
  (void)got("/api/nothing", 404);
  (void)asked("DELETE", "/api/runs/nothing", json::object(), 422);
  EXPECT_EQ(got("/api/health")["status"], "ok");
}

TEST_F(Serve, LeavesRunsAloneWhenItEndsOrIsKilled) {
  for (const int signal : {SIGINT, SIGKILL}) {
    const std::string run =
        begun({{"scenario", "guard"}, {"robots", 2}, {"speed", "max"}, {"duration", 400}});
    console_->send(signal);
    const Finished finished = console_->finish(20s);
    EXPECT_EQ(finished.exit_code, signal == SIGINT ? 0 : -1) << finished.err;
    begin();
    EXPECT_TRUE(becomes_true([&] { return state(run) == "done"; })) << state(run);
  }
}

TEST_F(Serve, IsNotReadyWithoutItsFolder) {
  std::filesystem::remove_all(scratch_ / "runs");
  EXPECT_NE(got("/api/ready", 503).value("error", "").find("runs"), std::string::npos);
  EXPECT_EQ(got("/api/health")["status"], "ok");
}

TEST_F(Serve, TakesItsWizardWithItWhenItIsKilled) {
  (void)asked("POST", "/api/plans", {{"map_name", "office"}, {"request", office_request(1)}}, 200);
  const std::string cases = scratch_ / "cases.db";
  const auto wizards = [&] { return count_of_processes(cases); };
  EXPECT_EQ(wizards(), 2);  // The console has the file in its command line as well.
  console_->send(SIGKILL);
  (void)console_->finish(20s);
  EXPECT_TRUE(becomes_true([&] { return wizards() == 0; }));
  begin();
}

TEST_F(Serve, TakesAnotherPortOrSaysThatItIsTaken) {
  Running second({program("console"), "serve", "--port", std::to_string(port_), "--runs",
                  (scratch_ / "other").string()});
  const Finished finished = second.finish(20s);
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_NE(finished.err.find(std::to_string(port_)), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace tacit
