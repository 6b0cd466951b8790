#include "console/live/live_run.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "console/live/graph.h"
#include "console/live/operator_services.h"
#include "idl/bus/cdr.h"
#include "idl/bus/participant.h"
#include "idl/bus/publisher.h"
#include "idl/bus/raw_subscriber.h"
#include "idl/schema/schema.h"

namespace tacit {
namespace {

using gateway::Channel;
using gateway::ChannelId;
using gateway::Keep;
using Clock = std::chrono::steady_clock;

/// A page that is loaded anew is away for a moment.
constexpr std::chrono::seconds kUnwatched{5};

Identity observer(const Venue& venue) {
  static std::atomic<std::uint32_t> count{0};
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  const std::uint32_t chance =
      static_cast<std::uint32_t>(::getpid()) ^ static_cast<std::uint32_t>(now) ^ ++count << 20U;
  return {Party::Console, {}, venue.domain, venue.run_nonce, chance | 1U};
}

template <class Topic>
Channel channel_of(RobotId robot, Keep keep) {
  const WireSchema schema = schema_of<Topic>();
  return {'/' + topic_name<Topic>(robot), "cdr",     std::string(schema.name),
          std::string(schema.text),       "ros2msg", keep};
}

std::uint64_t in_ns(double time_s) { return static_cast<std::uint64_t>(time_s * 1e9); }

/// What is read while somebody watches.
struct Readers {
  std::optional<RawSubscriber<topics::WorldView>> views;
  std::optional<RawSubscriber<topics::Status>> status;
  std::optional<RawSubscriber<topics::Events>> events;
  std::vector<RawSubscriber<topics::Telemetry>> telemetry;
};

}  // namespace

class LiveRun::Impl {
 public:
  Impl(std::shared_ptr<gateway::Session> session, const LiveRunFacts& facts)
      : session_(std::move(session)),
        tick_s_(facts.tick_s),
        participant_(observer(facts.venue)),
        controls_(participant_),
        view_out_(session_->advertise(channel_of<topics::WorldView>({}, Keep::Latest))),
        status_out_(session_->advertise(channel_of<topics::Status>({}, Keep::Latest))),
        events_out_(session_->advertise(channel_of<topics::Events>({}, Keep::All))) {
    for (std::int64_t robot = 1; robot <= facts.robots; ++robot) {
      telemetry_out_.push_back(session_->advertise(
          channel_of<topics::Telemetry>({static_cast<std::uint16_t>(robot)}, Keep::Latest)));
    }
    add_operator_services(*session_, [this](const Control& control) { say(control); });
    session_->set_connection_graph(connection_graph(facts.robots));
  }

  void say(const Control& control) {
    const std::lock_guard lock(controls_mutex_);
    controls_.publish(control);
  }

  void look() {
    const Clock::time_point now = Clock::now();
    if (session_->clients() > 0) {
      watched_ = now;
      if (!readers_) read();
    } else if (readers_ && now - watched_ > kUnwatched) {
      readers_.reset();
    }
  }

 private:
  void read() {
    readers_ = std::make_unique<Readers>();
    readers_->views.emplace(participant_, RobotId{}, [this](RawSample& sample) {
      hear_view(sample);
      session_->publish(view_out_, time_ns_, sample.bytes);
    });
    readers_->status.emplace(participant_, RobotId{}, [this](RawSample& sample) {
      hear_status(sample);
      session_->publish(status_out_, time_ns_, sample.bytes);
    });
    readers_->events.emplace(participant_, RobotId{}, [this](RawSample& sample) {
      session_->publish(events_out_, time_ns_, sample.bytes);
    });
    for (std::size_t i = 0; i < telemetry_out_.size(); ++i) {
      readers_->telemetry.emplace_back(participant_, RobotId{static_cast<std::uint16_t>(i + 1)},
                                       [this, out = telemetry_out_[i]](RawSample& sample) {
                                         session_->publish(out, time_ns_, sample.bytes);
                                       });
    }
  }

  void hear_view(const RawSample& sample) {
    if (!from_cdr(sample.bytes, view_)) move_time(view_.time_s);
  }

  void hear_status(const RawSample& sample) {
    RunStatus status;
    if (!from_cdr(sample.bytes, status)) move_time(static_cast<double>(status.tick) * tick_s_);
  }

  /// Topics come on threads of their own, and none may turn the clock back.
  void move_time(double time_s) {
    const std::uint64_t now = in_ns(time_s);
    std::uint64_t before = time_ns_;
    while (before < now && !time_ns_.compare_exchange_weak(before, now)) {
    }
    if (before < now) session_->set_time(now);
  }

  std::shared_ptr<gateway::Session> session_;
  const double tick_s_;
  std::atomic<std::uint64_t> time_ns_{0};
  WorldView view_;  ///< For the thread of that topic.
  Participant participant_;
  std::mutex controls_mutex_;
  Publisher<topics::Control> controls_;
  const ChannelId view_out_;
  const ChannelId status_out_;
  const ChannelId events_out_;
  std::vector<ChannelId> telemetry_out_;  ///< By robot.
  Clock::time_point watched_;
  std::unique_ptr<Readers> readers_;  ///< Goes first.
};

LiveRun::LiveRun(std::shared_ptr<gateway::Session> session, const LiveRunFacts& facts)
    : impl_(std::make_unique<Impl>(std::move(session), facts)) {}
LiveRun::~LiveRun() = default;

void LiveRun::look() { impl_->look(); }

void LiveRun::say(const Control& control) { impl_->say(control); }

}  // namespace tacit
