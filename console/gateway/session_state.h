#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "console/gateway/limits.h"
#include "console/gateway/messages.h"
#include "console/gateway/outbox.h"
#include "console/gateway/session.h"
#include "console/gateway/tally.h"

namespace tacit::gateway {

/// One client of a session. What is in it belongs to the session's state and its mutex.
struct SessionClient {
  explicit SessionClient(const Limits& limits) : outbox(limits) {}

  Outbox outbox;
  std::map<std::uint32_t, ChannelId> subscriptions;
  std::set<std::string> followed;  ///< Parameters.
  bool follows_graph = false;
  std::size_t calls = 0;       ///< That have no answer yet.
  bool awake = false;          ///< Its connection takes frames already, or has been told to.
  bool closing = false;        ///< It gets nothing any more.
  bool stalled = false;        ///< And that because it does not read.
  std::function<void()> wake;  ///< Makes its connection take frames.
};
using ClientPtr = std::shared_ptr<SessionClient>;

/// What a session holds: everything between the threads that publish and the one that sends.
/// Knows the protocol's words, but no socket. All functions may be called from any thread; no
/// handler of a user is called with the mutex held.
class SessionState : public std::enable_shared_from_this<SessionState> {
 public:
  SessionState(std::string id, std::string name, const Limits& limits,
               std::shared_ptr<Tally> tally);

  const std::string& id() const { return id_; }

  // For the side that publishes; as in Session.
  ChannelId advertise(const Channel& channel);
  void unadvertise(ChannelId channel);
  void publish(ChannelId channel, std::uint64_t log_time_ns, const Payload& bytes);
  bool wants(ChannelId channel) const;
  std::size_t subscribers(ChannelId channel) const;
  std::size_t clients() const;
  void set_time(std::uint64_t time_ns);
  ServiceId add_service(const Service& service, ServiceHandler handler);
  void remove_service(ServiceId service);
  void set_parameters(const std::vector<Parameter>& parameters);
  void on_parameters(ParameterHandler handler);
  void set_connection_graph(const ConnectionGraph& graph);
  void status(StatusLevel level, std::string_view message, std::string_view id);
  void remove_status(std::string_view id);
  void close();

  // For connections. `wake` may be called from any thread, with the mutex held.
  ClientPtr join(std::function<void()> wake);  ///< Null when the session is closed.
  void leave(const ClientPtr& client);
  enum class Fate { Stay, Go, Stalled };
  Fate fate(const ClientPtr& client) const;
  /// None: nothing to do until woken.
  std::optional<Frame> next(const ClientPtr& client);

  // For what clients say. A reason is why it is refused.
  using Reason = std::string;
  Reason subscribe(const ClientPtr& client, std::uint32_t subscription, ChannelId channel);
  Reason unsubscribe(const ClientPtr& client, std::uint32_t subscription);
  void call(const ClientPtr& client, ServiceId service, std::uint32_t call,
            std::string_view request);
  void give_parameters(const ClientPtr& client, const std::set<std::string>& names,
                       const messages::Json& question);
  void follow_parameters(const ClientPtr& client, const std::set<std::string>& names);
  void unfollow_parameters(const ClientPtr& client, const std::set<std::string>& names);
  Reason wish_parameters(const std::vector<Parameter>& wanted);
  void follow_graph(const ClientPtr& client, bool follow);
  void tell(const ClientPtr& client, Frame frame);

 private:
  struct OpenChannel {
    Channel channel;
    std::vector<std::pair<ClientPtr, std::uint32_t>> subscribers;  ///< With their subscriptions.
    Payload latest;
    std::uint64_t latest_ns = 0;
  };
  struct OpenService {
    Service service;
    std::shared_ptr<const ServiceHandler> handler;
  };
  struct Status {
    StatusLevel level = StatusLevel::Info;
    std::string message;
  };

  using Values = std::map<std::string, messages::ParameterValue>;

  void push(SessionClient& client, Frame frame);
  void push_to_all(const Frame& frame);
  void wake(SessionClient& client);
  void dismiss(SessionClient& client);
  void greet(SessionClient& client);
  void drop_subscriber(ChannelId channel, const ClientPtr& client);
  void send_message(const OpenChannel& channel, ChannelId id, std::size_t subscriber,
                    const Payload& bytes, std::uint64_t log_time_ns);
  Values values_of(const std::set<std::string>& names) const;
  std::shared_ptr<const ServiceHandler> begin_call(SessionClient& client, ServiceId service,
                                                   std::uint32_t call);
  void end_call(SessionClient& client, Frame answer);

  const std::string id_;
  const std::string name_;
  const Limits limits_;
  const std::shared_ptr<Tally> tally_;

  mutable std::mutex mutex_;
  bool closed_ = false;
  std::set<ClientPtr> clients_;
  std::map<ChannelId, OpenChannel> channels_;
  std::map<ServiceId, OpenService> services_;
  std::map<std::string, messages::ParameterValue> parameters_;
  std::shared_ptr<const ParameterHandler> parameter_handler_;
  std::map<std::string, Status, std::less<>> statuses_;
  ConnectionGraph graph_;
  std::optional<std::uint64_t> time_ns_;
  ChannelId next_channel_ = 1;
  ServiceId next_service_ = 1;
};

}  // namespace tacit::gateway
