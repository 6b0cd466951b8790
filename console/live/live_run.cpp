#include "console/live/live_run.h"

#include <unistd.h>

#include <chrono>
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

}  // namespace

class LiveRun::Impl {
 public:
  Impl(std::shared_ptr<gateway::Session> session, const LiveRunFacts& facts)
      : session_(std::move(session)),
        tick_s_(facts.tick_s),
        participant_(observer(facts.venue)),
        controls_(participant_) {
    listen_to_team();
    for (std::int64_t robot = 1; robot <= facts.robots; ++robot) {
      listen_to({static_cast<std::uint16_t>(robot)});
    }
    add_operator_services(*session_, [this](const Control& control) { say(control); });
    session_->set_connection_graph(connection_graph(facts.robots));
  }

  void say(const Control& control) {
    const std::lock_guard lock(controls_mutex_);
    controls_.publish(control);
  }

  [[nodiscard]] std::optional<RunStatus> status() const {
    const std::lock_guard lock(status_mutex_);
    return status_;
  }

 private:
  void listen_to_team() {
    const ChannelId view = session_->advertise(channel_of<topics::WorldView>({}, Keep::Latest));
    views_in_.emplace(participant_, RobotId{}, [this, view](RawSample& sample) {
      hear_view(sample);
      session_->publish(view, time_ns_, sample.bytes);
    });
    const ChannelId status = session_->advertise(channel_of<topics::Status>({}, Keep::Latest));
    status_in_.emplace(participant_, RobotId{}, [this, status](RawSample& sample) {
      hear_status(sample);
      session_->publish(status, time_ns_, sample.bytes);
    });
    const ChannelId events = session_->advertise(channel_of<topics::Events>({}, Keep::All));
    events_in_.emplace(participant_, RobotId{}, [this, events](RawSample& sample) {
      session_->publish(events, time_ns_, sample.bytes);
    });
  }

  void listen_to(RobotId robot) {
    const ChannelId telemetry =
        session_->advertise(channel_of<topics::Telemetry>(robot, Keep::Latest));
    telemetry_in_.emplace_back(participant_, robot, [this, telemetry](RawSample& sample) {
      session_->publish(telemetry, time_ns_, sample.bytes);
    });
  }

  void hear_view(const RawSample& sample) {
    if (!from_cdr(sample.bytes, view_)) move_time(view_.time_s);
  }

  void hear_status(const RawSample& sample) {
    RunStatus status;
    if (from_cdr(sample.bytes, status)) return;
    move_time(static_cast<double>(status.tick) * tick_s_);
    const std::lock_guard lock(status_mutex_);
    status_ = status;
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
  mutable std::mutex status_mutex_;
  std::optional<RunStatus> status_;
  Participant participant_;
  std::mutex controls_mutex_;
  Publisher<topics::Control> controls_;
  std::optional<RawSubscriber<topics::WorldView>> views_in_;
  std::optional<RawSubscriber<topics::Status>> status_in_;
  std::optional<RawSubscriber<topics::Events>> events_in_;
  std::vector<RawSubscriber<topics::Telemetry>> telemetry_in_;
};

LiveRun::LiveRun(std::shared_ptr<gateway::Session> session, const LiveRunFacts& facts)
    : impl_(std::make_unique<Impl>(std::move(session), facts)) {}
LiveRun::~LiveRun() = default;

std::optional<RunStatus> LiveRun::status() const { return impl_->status(); }

bool LiveRun::over() const {
  const std::optional<RunStatus> now = status();
  return now && (now->phase == RunPhase::Ended || now->phase == RunPhase::Stopped);
}

void LiveRun::say(const Control& control) { impl_->say(control); }

}  // namespace tacit
