#include "console/gateway/session_state.h"

#include <algorithm>
#include <stdexcept>

namespace tacit::gateway {

SessionState::SessionState(std::string id, std::string name, const Limits& limits,
                           std::shared_ptr<Tally> tally)
    : id_(std::move(id)), name_(std::move(name)), limits_(limits), tally_(std::move(tally)) {}

ChannelId SessionState::advertise(const Channel& channel) {
  const std::scoped_lock lock(mutex_);
  const ChannelId id = next_channel_++;
  if (!closed_) {
    channels_[id].channel = channel;
    push_to_all(messages::advertise(messages::Json::array({messages::channel(id, channel)})));
  }
  return id;
}

void SessionState::unadvertise(ChannelId channel) {
  const std::scoped_lock lock(mutex_);
  const auto open = channels_.find(channel);
  if (open == channels_.end()) {
    return;
  }
  for (const auto& [client, subscription] : open->second.subscribers) {
    client->subscriptions.erase(subscription);
    client->outbox.forget(channel);
  }
  channels_.erase(open);
  push_to_all(messages::unadvertise(channel));
}

void SessionState::publish(ChannelId channel, std::uint64_t log_time_ns, const Payload& bytes) {
  const std::scoped_lock lock(mutex_);
  const auto found = channels_.find(channel);
  if (found == channels_.end() || !bytes) {
    return;
  }
  OpenChannel& open = found->second;
  if (open.channel.keep == Keep::Latest) {
    open.latest = bytes;
    open.latest_ns = log_time_ns;
  }
  for (std::size_t i = 0; i < open.subscribers.size(); ++i) {
    send_message(open, channel, i, bytes, log_time_ns);
  }
}

bool SessionState::wants(ChannelId channel) const {
  const std::scoped_lock lock(mutex_);
  const auto open = channels_.find(channel);
  return open != channels_.end() &&
         (open->second.channel.keep == Keep::Latest || !open->second.subscribers.empty());
}

std::size_t SessionState::subscribers(ChannelId channel) const {
  const std::scoped_lock lock(mutex_);
  const auto open = channels_.find(channel);
  return open == channels_.end() ? 0 : open->second.subscribers.size();
}

std::size_t SessionState::clients() const {
  const std::scoped_lock lock(mutex_);
  return clients_.size();
}

void SessionState::set_time(std::uint64_t time_ns) {
  const std::scoped_lock lock(mutex_);
  if (closed_) {
    return;
  }
  time_ns_ = time_ns;
  for (const ClientPtr& client : clients_) {
    client->outbox.set_time(messages::time(time_ns));
    wake(*client);
  }
}

ServiceId SessionState::add_service(const Service& service, ServiceHandler handler) {
  const std::scoped_lock lock(mutex_);
  const ServiceId id = next_service_++;
  if (!closed_) {
    services_[id] = {service, std::make_shared<const ServiceHandler>(std::move(handler))};
    push_to_all(
        messages::advertise_services(messages::Json::array({messages::service(id, service)})));
  }
  return id;
}

void SessionState::remove_service(ServiceId service) {
  OpenService removed;  // Its handler goes when the mutex is free again.
  const std::scoped_lock lock(mutex_);
  const auto open = services_.find(service);
  if (open != services_.end()) {
    removed = std::move(open->second);
    services_.erase(open);
    push_to_all(messages::unadvertise_service(service));
  }
}

void SessionState::set_connection_graph(const ConnectionGraph& graph) {
  const std::scoped_lock lock(mutex_);
  if (closed_) {
    return;
  }
  const Frame update = messages::graph_update(graph_, graph);
  graph_ = graph;
  for (const ClientPtr& client : clients_) {
    if (client->follows_graph) {
      push(*client, update);
    }
  }
}

void SessionState::status(StatusLevel level, std::string_view message, std::string_view id) {
  const std::scoped_lock lock(mutex_);
  if (closed_) {
    return;
  }
  if (!id.empty()) {
    statuses_.insert_or_assign(std::string(id), Status{level, std::string(message)});
  }
  push_to_all(messages::status(level, message, id));
}

void SessionState::remove_status(std::string_view id) {
  const std::scoped_lock lock(mutex_);
  const auto status = statuses_.find(id);
  if (status != statuses_.end()) {
    statuses_.erase(status);
    push_to_all(messages::remove_status(id));
  }
}

void SessionState::close() {
  // Handlers may hold what ends with them, a Session for one: they go when the mutex is free.
  std::map<ServiceId, OpenService> services;
  std::shared_ptr<const ParameterHandler> parameter_handler;
  const std::scoped_lock lock(mutex_);
  closed_ = true;
  channels_.clear();
  services.swap(services_);
  parameter_handler.swap(parameter_handler_);
  for (const ClientPtr& client : clients_) {
    dismiss(*client);
  }
}

/// Its connection may be waiting for a write to end, and is told all the same.
void SessionState::dismiss(SessionClient& client) {
  client.closing = true;
  if (client.wake) {
    client.wake();
  }
}

void SessionState::push(SessionClient& client, Frame frame) {
  if (client.closing) {
    return;
  }
  client.outbox.push(std::move(frame));
  if (client.outbox.is_overfull()) {
    client.stalled = true;
    dismiss(client);
  }
  wake(client);
}

void SessionState::push_to_all(const Frame& frame) {
  for (const ClientPtr& client : clients_) {
    push(*client, frame);
  }
}

void SessionState::wake(SessionClient& client) {
  if (!client.awake && client.wake) {
    client.awake = true;
    client.wake();
  }
}

void SessionState::send_message(const OpenChannel& channel, ChannelId id, std::size_t subscriber,
                                const Payload& bytes, std::uint64_t log_time_ns) {
  const auto& [client, subscription] = channel.subscribers[subscriber];
  tally_->messages_dropped += client->outbox.push_message(
      id, channel.channel.keep, messages::message_data(subscription, log_time_ns, bytes));
  wake(*client);
}

}  // namespace tacit::gateway
