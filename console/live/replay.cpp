#include "console/live/replay.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "console/mcap/reader.h"

namespace tacit {
namespace {

using gateway::ChannelId;
using gateway::ServiceReply;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kSecond = 1'000'000'000;
/// How often messages are sent.
constexpr std::chrono::milliseconds kBeat{20};
/// How often people are told where the clock stands.
constexpr std::chrono::milliseconds kTell{200};
/// What is read at once; a chunk is unpacked for it.
constexpr std::uint64_t kAhead_ns = 10 * kSecond;
/// How far back the state at a moment is looked for.
constexpr std::uint64_t kBack_ns = 3 * kSecond;
constexpr double kFastest = 1000.0;
constexpr double kStep_s = 0.1;

/// Events are happenings; all else is a state, of which the newest counts.
bool is_state(const std::string& topic) { return topic != "/tacit/events"; }

double number(const json& request, const char* name, double low, double high) {
  const auto at = request.find(name);
  if (at == request.end() || !at->is_number() || !(at->get<double>() >= low) ||
      !(at->get<double>() <= high)) {
    throw std::runtime_error(std::string(name) + ": found " +
                             (at == request.end() ? "nothing" : at->dump()) + ", wanted " +
                             json(low).dump() + " to " + json(high).dump());
  }
  return at->get<double>();
}

struct Waiting {
  std::uint64_t time_ns = 0;
  std::uint16_t channel = 0;
  std::vector<std::uint8_t> bytes;
};

}  // namespace

class Replay::Impl {
 public:
  Impl(std::shared_ptr<gateway::Session> session, const std::filesystem::path& file)
      : session_(std::move(session)),
        reader_(file),
        start_ns_(reader_.statistics().start_ns),
        end_ns_(std::max(reader_.statistics().end_ns, start_ns_)),
        time_ns_(start_ns_) {
    advertise();
    offer_services();
    thread_ = std::thread([this] { play(); });
  }
  ~Impl() {
    {
      const std::lock_guard lock(mutex_);
      home_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

 private:
  void advertise() {
    for (const auto& [id, channel] : reader_.channels()) {
      const auto schema = reader_.schemas().find(channel.schema);
      gateway::Channel made{channel.topic, channel.encoding, {}, {}, {}, gateway::Keep::All};
      if (schema != reader_.schemas().end()) {
        made.schema_name = schema->second.name;
        made.schema = schema->second.text;
        made.schema_encoding = schema->second.encoding;
      }
      if (is_state(channel.topic)) made.keep = gateway::Keep::Latest;
      channels_[id] = session_->advertise(made);
    }
  }

  void offer_services() {
    offer("pause", [this](const json&) { playing_ = false; });
    offer("resume", [this](const json&) { playing_ = true; });
    offer("speed",
          [this](const json& request) { speed_ = number(request, "factor", 0.01, kFastest); });
    offer("step", [this](const json& request) {
      playing_ = false;
      const double ticks = request.contains("ticks") ? number(request, "ticks", 1, 1e6) : 1.0;
      until_ns_ = time_ns_ + static_cast<std::uint64_t>(ticks * kStep_s * 1e9);
    });
    offer("seek", [this](const json& request) {
      const double time_s = number(request, "time_s", 0.0, 1e9);
      seek_ns_ = std::clamp(static_cast<std::uint64_t>(time_s * 1e9), start_ns_, end_ns_);
    });
  }

  void offer(const char* name, std::function<void(const json&)> act) {
    session_->add_service(
        {name, std::string("tacit/replay_") + name, R"({"type":"object"})", R"({"type":"object"})"},
        [this, act = std::move(act)](std::string_view request, const ServiceReply& reply) {
          const json given = json::parse(request, nullptr, false);
          try {
            if (!given.is_object()) throw std::runtime_error("found no JSON object, wanted one");
            const std::lock_guard lock(mutex_);
            act(given);
          } catch (const std::exception& error) {
            return reply.fail(error.what());
          }
          wake_.notify_one();
          reply.ok("{}");
        });
  }

  void play() {
    show_state_at(time_ns_);
    tell();
    Clock::time_point told = Clock::now();
    Clock::time_point before = told;
    std::unique_lock lock(mutex_);
    while (!home_) {
      wake_.wait_for(lock, kBeat);
      const Clock::time_point now = Clock::now();
      const double passed_s = std::chrono::duration<double>(now - before).count();
      before = now;
      if (const auto seek = std::exchange(seek_ns_, std::nullopt)) {
        until_ns_.reset();
        lock.unlock();
        move_to(*seek);
        lock.lock();
      }
      const std::uint64_t to = goal(passed_s);
      lock.unlock();
      if (to > time_ns_) send_until(to);
      if (now - told >= kTell) {
        told = now;
        tell();
      }
      lock.lock();
      if (time_ns_ >= end_ns_) playing_ = false;
    }
  }

  /// Where the clock is to stand now. Under the mutex.
  std::uint64_t goal(double passed_s) {
    if (until_ns_) return std::min(*std::exchange(until_ns_, std::nullopt), end_ns_);
    if (!playing_) return time_ns_;
    return std::min(time_ns_ + static_cast<std::uint64_t>(passed_s * speed_ * 1e9), end_ns_);
  }

  void move_to(std::uint64_t time_ns) {
    waiting_.clear();
    read_to_ns_ = time_ns;
    set_time(time_ns);
    show_state_at(time_ns);
    tell();
  }

  void set_time(std::uint64_t time_ns) {
    time_ns_ = time_ns;
    session_->set_time(time_ns);
  }

  /// The newest of each state that was recorded until then; where there is none yet, the first.
  void show_state_at(std::uint64_t time_ns) {
    std::map<std::uint16_t, Waiting> newest;
    const std::uint64_t from = time_ns > start_ns_ + kBack_ns ? time_ns - kBack_ns : start_ns_;
    read({from, time_ns + kSecond}, [&](const mcap::Message& message) {
      const bool later = message.log_time_ns > time_ns;
      if (!is_state(reader_.channels().at(message.channel).topic)) return;
      if (later && newest.contains(message.channel)) return;
      newest[message.channel] = {message.log_time_ns, message.channel, {}};
      newest[message.channel].bytes.assign(message.data.begin(), message.data.end());
    });
    for (const auto& [channel, one] : newest) {
      session_->publish(channels_.at(channel), one.time_ns, one.bytes);
    }
    read_to_ns_ = time_ns;
  }

  void send_until(std::uint64_t to) {
    while (read_to_ns_ < to) read_ahead();
    while (!waiting_.empty() && waiting_.front().time_ns <= to) {
      const Waiting& one = waiting_.front();
      session_->publish(channels_.at(one.channel), one.time_ns, one.bytes);
      waiting_.pop_front();
    }
    set_time(to);
  }

  void read_ahead() {
    const std::uint64_t from = read_to_ns_ + 1;
    read_to_ns_ += kAhead_ns;
    read({from, read_to_ns_}, [&](const mcap::Message& message) {
      waiting_.push_back({message.log_time_ns, message.channel, {}});
      waiting_.back().bytes.assign(message.data.begin(), message.data.end());
    });
  }

  /// A chunk that is damaged is told of, and what lies behind it goes on.
  void read(McapReader::Stretch stretch, const std::function<void(const mcap::Message&)>& take) {
    try {
      reader_.read(stretch, take);
    } catch (const McapError& error) {
      session_->status(gateway::StatusLevel::Error, error.what(), "recording");
    }
  }

  void tell() {
    const auto seconds = [](std::uint64_t ns) { return static_cast<double>(ns) / 1e9; };
    json now;
    {
      const std::lock_guard lock(mutex_);
      now = {{"start_s", seconds(start_ns_)},
             {"end_s", seconds(end_ns_)},
             {"time_s", seconds(time_ns_)},
             {"playing", playing_},
             {"speed", speed_}};
    }
    session_->set_parameters({{"replay", now.dump()}});
  }

  std::shared_ptr<gateway::Session> session_;
  McapReader reader_;  ///< Of the playing thread, once that runs.
  const std::uint64_t start_ns_;
  const std::uint64_t end_ns_;
  std::map<std::uint16_t, ChannelId> channels_;
  std::deque<Waiting> waiting_;  ///< Read and not yet due; of the playing thread.
  std::uint64_t read_to_ns_ = 0;

  std::mutex mutex_;
  std::condition_variable wake_;
  std::atomic<std::uint64_t> time_ns_;
  bool playing_ = false;
  double speed_ = 1.0;
  std::optional<std::uint64_t> until_ns_;
  std::optional<std::uint64_t> seek_ns_;
  bool home_ = false;
  std::thread thread_;
};

Replay::Replay(std::shared_ptr<gateway::Session> session, const std::filesystem::path& file)
    : impl_(std::make_unique<Impl>(std::move(session), file)) {}
Replay::~Replay() = default;

}  // namespace tacit
